#include "drivers/recordings/slice/move_frame.hpp"

#include <fmt/format.h>

#include <cmath>

#include "drivers/measurement/units.hpp"
#include "drivers/wire/bytes.hpp"
#include "drivers/wire/fields.hpp"
#include "drivers/wire/j1939/j1939.hpp"
#include "drivers/wire/j1939/j1939_transport.hpp"

namespace drydock::slice {

namespace {

constexpr std::uint32_t rapid_position = 129025;

/// NMEA 2000's groups of navigation, AIS and GNSS, weather stations, Loran, waypoints and magnetic
/// variation; J1939's vehicle position. Course and speed (129026) and dilutions (129539) do not
/// show the place.
constexpr bool tells_place(std::uint32_t pgn) {
  constexpr std::uint32_t course_and_speed = 129026, dilutions = 129539;
  if (pgn == course_and_speed || pgn == dilutions) return false;
  return (pgn >= 129024 && pgn < 130048) || (pgn >= 130050 && pgn < 130080) ||
         (pgn >= 130320 && pgn <= 130324) || pgn == 127258 || pgn == 65267;
}

/// Latitude and longitude are in 1e-7 degree; the highest value means "not available".
void move_rapid_position(wire::CanFrame& frame, Displacement& place) {
  const double step = units::degree / 1e7;
  const auto latitude = wire::load_le<std::int32_t>(frame.payload(), 0);
  const auto longitude = wire::load_le<std::int32_t>(frame.payload(), 4);
  constexpr std::int32_t no_value = 0x7FFFFFFF;
  if (latitude == no_value || longitude == no_value) return;
  place.start_at({latitude * step, longitude * step});
  const auto moved = place({latitude * step, longitude * step});
  const auto steps = [&](double rad) { return static_cast<std::int32_t>(std::lround(rad / step)); };
  wire::store_le<std::int32_t>(frame.data, 0, steps(moved.latitude_rad));
  wire::store_le<std::int32_t>(frame.data, 4, steps(moved.longitude_rad));
}

}  // namespace

bool BusPlace::drop(std::uint32_t pgn) {
  ++dropped_[fmt::format("PGN {}", pgn)];
  return false;
}

bool BusPlace::move(wire::CanFrame& frame) {
  const auto id = wire::j1939::identify(frame);
  if (!id) return true;
  if (id->pgn == rapid_position && frame.size == 8) {
    move_rapid_position(frame, place_);
    ++moved_;
    return true;
  }
  if (id->pgn == wire::j1939::transport_control_pgn && frame.size == 8) {
    const std::uint32_t pgn = wire::load_le<std::uint32_t>(frame.payload(), 4) >> 8;
    hidden_transport_.erase(id->source);
    if (!tells_place(pgn)) return true;
    hidden_transport_.insert(id->source);
    return drop(pgn);
  }
  if (id->pgn == wire::j1939::transport_data_pgn && hidden_transport_.contains(id->source))
    return drop(id->pgn);
  return tells_place(id->pgn) ? drop(id->pgn) : true;
}

}  // namespace drydock::slice
