#pragma once

#include <Eigen/Core>
#include <optional>

#include "drivers/measurement/units.hpp"
#include "estimators/roll/sight_line.hpp"

namespace drydock::roll {

/// Properties of antenna and receiver. Powers are relative to the power at boresight.
struct AntennaOptions {
  Eigen::Vector3d boresight_body{0, 0, 1};   ///< unit vector; paper: +z
  double width_rad = 64.58 * units::degree;  ///< of eq. (23); paper
  double noise = 0.1;        ///< 1 sigma of a power; paper: 10 % of that at boresight
  double resolution_db = 0;  ///< of C/N0 on the wire; 0: not rounded
  /// The receiver does not track a weaker signal, so the power of an untracked signal is below this
  /// limit. Empty: the limit is unknown, and a missing signal says nothing.
  std::optional<double> tracking_limit;
};

struct Power {
  double value = 0;
  double slope = 0;  ///< per radian of roll
};

/// Eq. (23), corrected.
Power power_of(const AntennaOptions& antenna, const SightLine& line, double roll_rad);

}  // namespace drydock::roll
