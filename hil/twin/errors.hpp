#pragma once

#include <array>
#include <span>
#include <vector>

#include "drivers/measurement/measurement.hpp"
#include "hil/motion/truth.hpp"
#include "rig_config/rig.hpp"

namespace drydock::twin {

/// A measurement less what a perfect sensor at its place would have said on the track, in the
/// quantities and axes of a sensor file (characterize::quantities_of), SI. NaN: not measured.
struct Error {
  measurement::Stamp valid_at{};
  /// Primary, secondary quantity.
  std::array<Eigen::Vector3d, 2> of{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
};

/// Errors of one device's measurements. An actuator has none: nobody knows what it should have
/// said.
std::vector<Error> errors_of(std::span<const measurement::Measurement> measured,
                             const rig_config::DeviceConfig& device,
                             const motion::Trajectory& track);

}  // namespace drydock::twin
