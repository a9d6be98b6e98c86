#pragma once

#include <memory>
#include <span>
#include <vector>

#include "drivers/bus/device.hpp"
#include "drivers/device/device.hpp"
#include "rig_config/rig.hpp"

namespace drydock::host {

/// The rig's devices as the bus knows them: name, kind, and where their measurements come from.
std::vector<bus::Device> bus_devices(const rig_config::Rig& rig);
std::vector<bus::Device> bus_devices(std::span<const std::unique_ptr<device::Device>> devices);

std::vector<std::string> estimator_names(const rig_config::Rig& rig);
std::vector<std::string> navigator_names(const rig_config::Rig& rig);  ///< that give positions

/// Which sensors are compared with what an estimator expects of them.
std::vector<bus::InnovationSource> innovation_sources(const rig_config::Rig& rig);

/// Where the measurements of a device with this link come from, told by the URI alone.
measurement::Provenance provenance_of(const std::string& link);

/// One status of `rt/diagnostics`.
bus::DeviceStatus status_of(const device::Device& device, const device::Health& health);

}  // namespace drydock::host
