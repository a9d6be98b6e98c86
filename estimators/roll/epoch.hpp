#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "estimators/roll/sight_line.hpp"

namespace drydock::roll {

/// Most satellites that a filter follows at once; further ones of an epoch are passed over.
inline constexpr std::size_t most_satellites = 16;

struct Signal {
  std::uint16_t satellite = 0;  ///< the same number for the same satellite, at all epochs
  Eigen::Vector3d toward_ned = Eigen::Vector3d::Zero();  ///< unit vector
  std::optional<double> power;  ///< share of that at boresight; empty: known of, but not tracked
};

/// What the receiver says of one instant.
struct Epoch {
  std::span<const Signal> signals;  ///< each satellite once
  FlightPath path;
  double age_s = 0;       ///< how long before the filter's time it was true
  double turned_rad = 0;  ///< what the gyro has counted since
};

}  // namespace drydock::roll
