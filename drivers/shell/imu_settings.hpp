#pragma once

#include <boost/system/result.hpp>
#include <string>

#include "drivers/device/driver_options.hpp"
#include "rig_config/rig.hpp"

namespace drydock::shell {

/// A key of the device in the rig file, such as `aceinna/orientation`; one line with the error and
/// the permitted values.
struct SettingsError {
  std::string key, message;
};

/// The rig file's settings of an Aceinna IMU, in the numbers of its setup messages.
boost::system::result<device::AceinnaSettings, SettingsError> aceinna_settings(
    const rig_config::AceinnaConfig& config);

/// The identifiers of an Xsens IMU: the factory values, except those that the rig file names.
boost::system::result<wire::xsens::Identifiers, SettingsError> xsens_identifiers(
    const rig_config::XsensConfig& config);

}  // namespace drydock::shell
