#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "estimators/roll/sight_line.hpp"

namespace drydock::roll {

/// The number of satellites that a filter can follow at once. It ignores further ones of an epoch.
inline constexpr std::size_t most_satellites = 16;

struct Signal {
  std::uint16_t satellite = 0;                           ///< identifies the satellite at all epochs
  Eigen::Vector3d toward_ned = Eigen::Vector3d::Zero();  ///< unit vector
  std::optional<double> power;  ///< relative to boresight; empty: known, but not tracked
};

/// The signals of one instant.
struct Epoch {
  std::span<const Signal> signals;  ///< each satellite once
  FlightPath path;
  double age_s = 0;       ///< time from the epoch to the time of the filter
  double turned_rad = 0;  ///< integral of the gyro over this time
};

}  // namespace drydock::roll
