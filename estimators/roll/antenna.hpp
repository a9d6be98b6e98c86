#pragma once

#include <Eigen/Core>
#include <numbers>
#include <optional>

#include "estimators/roll/sight_line.hpp"

namespace drydock::roll {

/// What is known of antenna and receiver. Powers are shares of that at boresight.
struct AntennaOptions {
  Eigen::Vector3d boresight_body{0, 0, 1};            ///< unit vector; paper: +z
  double width_rad = 64.58 * std::numbers::pi / 180;  ///< of eq. (23); paper
  double noise = 0.1;        ///< 1 sigma of a power; paper: 10 % of that at boresight
  double resolution_db = 0;  ///< of C/N0 on the wire; 0: not rounded
  /// A weaker signal is not tracked, and that says so much of it; empty: no signal is too weak.
  std::optional<double> tracking_limit;
};

struct Power {
  double value = 0;
  double slope = 0;  ///< per radian of roll
};

/// Eq. (23) put right.
Power power_of(const AntennaOptions& antenna, const SightLine& line, double roll_rad);

}  // namespace drydock::roll
