#pragma once

#include <span>
#include <string_view>

#include "drivers/measurement/kind.hpp"

namespace drydock::rig_config {

/// A key of `[[estimator]]` that names a device, and the kind that this device must have.
struct DeviceKey {
  std::string_view key;
  measurement::Kind kind;
};

/// What the rest of the program knows about a kind of estimator. Nearly every estimator has an IMU.
/// It gives roll and pitch; one in another program may give others. Each kind has one row, in the
/// header of its keys.
struct EstimatorFacts {
  std::string_view name;               ///< `kind` in the rig file
  std::span<const DeviceKey> devices;  ///< besides `imu`
  bool gives_positions = false;        ///< gives position, velocity and heading too
  bool has_gate = false;               ///< counts the values that it rejects
  bool has_innovations = false;        ///< compares values with what it expects
  bool has_imu = true;                 ///< `imu` names it; otherwise the speed gives the pace
};

}  // namespace drydock::rig_config
