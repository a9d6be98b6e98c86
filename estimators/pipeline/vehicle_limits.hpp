#pragma once

namespace drydock::pipeline {

/// What an underwater vehicle can do: docs/estimators/integrity.md has the sources. A rig of
/// another kind of vehicle needs other limits.
struct VehicleLimits {
  double turn_radps = 10;           ///< each axis
  double acceleration_mps2 = 5;     ///< how far the specific force may differ from gravity
  double turn_change_radps2 = 0.5;  ///< angular acceleration, each axis
  double force_change_mps3 = 20;    ///< change of the specific force, each axis
};

}  // namespace drydock::pipeline
