#pragma once

#include <memory>
#include <span>
#include <vector>

#include "drivers/bus/device.hpp"
#include "drivers/device/device.hpp"
#include "rig_config/rig.hpp"

namespace drydock::host {

/// The rig's devices in the form of the bus: name, kind, and the provenance of their measurements.
std::vector<bus::Device> bus_devices(const rig_config::Rig& rig);
std::vector<bus::Device> bus_devices(std::span<const std::unique_ptr<device::Device>> devices);

/// A rig in memory with these devices, for a wire that no rig file describes.
rig_config::Rig rig_of(std::span<const std::unique_ptr<device::Device>> devices,
                       const std::string& name);

std::vector<std::string> estimator_names(const rig_config::Rig& rig);
std::vector<std::string> navigator_names(const rig_config::Rig& rig);  ///< they give positions

/// The sensors that are compared with an estimator's predictions.
std::vector<bus::InnovationSource> innovation_sources(const rig_config::Rig& rig);

/// The provenance of a device's measurements. Only the URI of its link decides it.
measurement::Provenance provenance_of(const std::string& link);

/// One status of `rt/diagnostics`.
bus::DeviceStatus status_of(const device::Device& device, const device::Health& health);

}  // namespace drydock::host
