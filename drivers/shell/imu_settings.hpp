#pragma once

#include <boost/system/result.hpp>
#include <string>

#include "drivers/device/driver_options.hpp"
#include "rig_config/rig.hpp"

namespace drydock::shell {

/// What is wrong and what is allowed.
struct SettingsError {
  std::string message;
};

/// What the rig file says of an Aceinna IMU, in the numbers that its setup messages hold.
boost::system::result<device::AceinnaSettings, SettingsError> aceinna_settings(
    const rig_config::AceinnaConfig& config);

/// The identifiers of an Xsens IMU: as delivered, but for those named.
boost::system::result<wire::xsens::Identifiers, SettingsError> xsens_identifiers(
    const rig_config::XsensConfig& config);

}  // namespace drydock::shell
