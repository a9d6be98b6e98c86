#pragma once

#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string_view>

#include "drivers/measurement/measurement.hpp"

namespace drydock::diagnosis {

/// One number that a sensor measures. Not in it: counters, clocks and what the sensor was told.
enum class Quantity : std::uint8_t {
  // clang-format off
  force_x, force_y, force_z, rate_x, rate_y, rate_z,
  pressure, depth,
  bottom_x, bottom_y, bottom_z,
  log_x, log_y,
  north, east, velocity_north, velocity_east, velocity_down, ground_speed,
  rudder, stern_plane, bow_plane, shaft,
  heading, roll, pitch, turn_rate
  // clang-format on
};
inline constexpr std::size_t quantities = static_cast<std::size_t>(Quantity::turn_rate) + 1;

/// What no vehicle under water or on it does, in the unit of the quantity.
struct QuantityFacts {
  std::string_view name, unit;
  double wild = 0;   ///< a single sample this far off its two neighbours is impossible
  double bend = 0;   ///< largest second derivative of a usual motion, unit/s2
  double slope = 0;  ///< largest first derivative; 0: any (a step is then no sign)
  bool angle = false;
  double tremble = 0;  ///< as `bend`, of a motion that turns twice in four samples; 0: any
};
const QuantityFacts& facts_of(Quantity quantity);

struct Reading {
  Quantity quantity = Quantity::force_x;
  double value = 0;
};
using Readings = boost::container::static_vector<Reading, 8>;

/// The numbers of a measurement. Positions are metres from `home`, which the first position sets.
Readings readings_of(const measurement::Measurement& measurement,
                     std::optional<measurement::Geodetic>& home);

/// The kind of a message: its kind of measurement and, where a device sends several messages of
/// that kind, the values that tell them apart. A value that comes and goes with the surroundings
/// (bottom lock, fix) makes no other kind.
std::uint32_t stream_of(const measurement::Measurement& measurement);

}  // namespace drydock::diagnosis
