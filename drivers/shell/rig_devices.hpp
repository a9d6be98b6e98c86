#pragma once

#include <boost/system/result.hpp>
#include <memory>
#include <string>
#include <vector>

#include "drivers/device/device.hpp"
#include "rig_config/rig.hpp"

namespace drydock::shell {

/// One line: `file:line: device "name": ` and then the error and the permitted values.
struct RigDevicesError {
  std::string message;
};

/// Why a device of a rig cannot be made: a key of its block, such as `aceinna/orientation`, and one
/// line with the error and the permitted values.
struct DeviceRefusal {
  std::string key, message;
};

/// The device at `index` of the rig. Opens no link.
boost::system::result<std::unique_ptr<device::Device>, DeviceRefusal> make_device(
    const rig_config::Rig& rig, std::size_t index);

/// Converts the rig file's entry for a device to the options of the driver layer. `index` is its
/// place in the rig.
boost::system::result<device::DeviceOptions, RigDevicesError> device_options(
    const rig_config::Rig& rig, std::size_t index);

/// All devices of a rig, in the order of the file.
boost::system::result<std::vector<std::unique_ptr<device::Device>>, RigDevicesError> make_devices(
    const rig_config::Rig& rig);

}  // namespace drydock::shell
