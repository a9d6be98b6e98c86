#include <algorithm>
#include <array>
#include <cmath>

#include "drivers/device/gnss/ecef.hpp"
#include "drivers/measurement/units.hpp"
#include "drivers/recordings/slice/move_message.hpp"
#include "drivers/wire/ubx/ubx.hpp"
#include "drivers/wire/ubx/ubx_frame.hpp"

namespace drydock::slice {

namespace {

using Payload = std::span<std::uint8_t>;

/// These contain neither a position nor satellites: times, velocity, accuracy, status,
/// acknowledgements, version.
constexpr std::array<std::uint16_t, 9> harmless_ubx{
    wire::NavVelned::class_and_id,
    wire::NavDop::class_and_id,
    wire::NavStatus::class_and_id,
    wire::NavTimeGps::class_and_id,
    wire::NavTimeUtc::class_and_id,
    wire::NavEoe::class_and_id,
    0x0500,  // ACK-NAK
    0x0501,  // ACK-ACK
    0x0A04   // MON-VER
};

/// Longitude and latitude are in 1e-7 degree. The height behind them is replaced by the height
/// above mean sea level.
void move_geodetic(Payload payload, std::size_t offset, Displacement& place) {
  const double step = units::degree / 1e7;
  const measurement::Geodetic old{wire::load_le<std::int32_t>(payload, offset + 4) * step,
                                  wire::load_le<std::int32_t>(payload, offset) * step};
  place.start_at(old);
  const auto moved = place(old);
  const auto steps = [&](double rad) { return static_cast<std::int32_t>(std::lround(rad / step)); };
  wire::store_le<std::int32_t>(payload, offset, steps(moved.longitude_rad));
  wire::store_le<std::int32_t>(payload, offset + 4, steps(moved.latitude_rad));
  wire::store_le<std::int32_t>(payload, offset + 8,
                               wire::load_le<std::int32_t>(payload, offset + 12));
}

Eigen::Vector3d vector_at(Payload payload, std::size_t offset) {
  const auto axis = [&](std::size_t i) {
    return wire::load_le<std::int32_t>(payload, offset + 4 * i) / 100.0;
  };
  return {axis(0), axis(1), axis(2)};
}

void store_vector(Payload payload, std::size_t offset, const Eigen::Vector3d& vector) {
  for (std::size_t i = 0; i < 3; ++i)
    wire::store_le<std::int32_t>(
        payload, offset + 4 * i,
        static_cast<std::int32_t>(std::lround(vector[static_cast<Eigen::Index>(i)] * 100)));
}

/// Position and velocity are in Earth-centred axes, cm. The new place is at the height of the
/// ellipsoid.
void move_ecef(Payload payload, std::size_t position, std::size_t velocity, Displacement& place) {
  const auto ecef = vector_at(payload, position);
  if (ecef.isZero()) return;  // there is no fix yet
  const auto old = device::from_ecef(ecef).horizontal;
  place.start_at(old);
  const auto moved = place(old);
  store_vector(payload, position, device::to_ecef({moved, 0}));
  const auto ned = device::ned_of_ecef(vector_at(payload, velocity), old);
  store_vector(payload, velocity, device::ecef_of_ned(ned, moved));
}

}  // namespace

Fate move_ubx(std::span<std::uint8_t> frame, Displacement& place) {
  const auto id = wire::load_be<std::uint16_t>(frame, 2);
  if (std::ranges::find(harmless_ubx, id) != harmless_ubx.end()) return Fate::as_it_is;
  const Payload payload = frame.subspan(wire::ubx::header_size, frame.size() - wire::ubx::overhead);
  if (id == wire::NavPvt::class_and_id && payload.size() >= 84) {
    constexpr std::uint8_t declination_valid = 1 << 3;
    move_geodetic(payload, 24, place);
    payload[11] = static_cast<std::uint8_t>(payload[11] & ~declination_valid);
    if (payload.size() >= 92) wire::store_le<std::uint32_t>(payload, 88, 0);  // declination
  } else if (id == wire::NavPosllh::class_and_id && payload.size() == 28) {
    move_geodetic(payload, 4, place);
  } else if (id == wire::NavSol::class_and_id && payload.size() == 52) {
    move_ecef(payload, 12, 28, place);
  } else {
    return Fate::dropped;
  }
  wire::ubx::wrap(frame, id, payload.size());
  return Fate::moved;
}

}  // namespace drydock::slice
