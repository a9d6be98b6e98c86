#include "drivers/diagnosis/monitors/quantity.hpp"

#include <array>
#include <cmath>

namespace drydock::diagnosis {
namespace {

using namespace measurement;

constexpr double degree = std::numbers::pi / 180;
constexpr double rpm = 2 * std::numbers::pi / 60;

// Wild: beyond what a small craft does within one sample. Bends and slopes: seaway and manoeuvres
// of small craft (IMU: its mounting's vibration as well).
// clang-format off
constexpr auto facts = std::to_array<QuantityFacts>({
    {"specific force x", "m/s2", 4, 60},
    {"specific force y", "m/s2", 4, 60},
    {"specific force z", "m/s2", 4, 60},
    {"roll rate", "rad/s", 20 * degree, 2, 0, false, 0.1},
    {"pitch rate", "rad/s", 20 * degree, 2, 0, false, 0.1},
    {"yaw rate", "rad/s", 20 * degree, 2, 0, false, 0.1},
    {"pressure", "Pa", 30e3, 10e3, 20e3},
    {"depth", "m", 3, 1, 2},
    {"bottom velocity x", "m/s", 0.8, 0.5, 1.2},
    {"bottom velocity y", "m/s", 0.8, 0.5, 1.2},
    {"bottom velocity z", "m/s", 0.8, 0.5, 1.2},
    {"speed through water x", "m/s", 1.5, 0.5, 1.2},
    {"speed through water y", "m/s", 1.5, 0.5, 1.2},
    {"position north", "m", 60, 2, 20},
    {"position east", "m", 60, 2, 20},
    {"velocity north", "m/s", 4, 1, 3},
    {"velocity east", "m/s", 4, 1, 3},
    {"velocity down", "m/s", 4, 1, 3},
    {"ground speed", "m/s", 4, 1, 3},
    {"rudder", "rad", 8 * degree, 50},
    {"stern plane", "rad", 8 * degree, 50},
    {"bow plane", "rad", 8 * degree, 50},
    {"shaft", "rad/s", 200 * rpm, 5000},
    {"heading", "rad", 10 * degree, 1, 60 * degree, true},
    {"roll", "rad", 10 * degree, 1, 0, true},
    {"pitch", "rad", 10 * degree, 1, 0, true},
    {"rate of turn", "rad/s", 15 * degree, 1},
});
// clang-format on
static_assert(facts.size() == quantities);

struct Reader {
  Readings& out;
  std::optional<Geodetic>& home;

  void put(Quantity quantity, const std::optional<double>& value) const {
    if (value) out.push_back({quantity, *value});
  }
  void put(Quantity first, const Eigen::Vector3d& value) const {
    for (int i = 0; i < 3; ++i)
      out.push_back({static_cast<Quantity>(static_cast<int>(first) + i), value[i]});
  }

  void operator()(const ImuSample& m) const {
    put(Quantity::force_x, m.specific_force);
    put(Quantity::rate_x, m.angular_rate);
  }
  void operator()(const DepthSample& m) const {
    put(Quantity::pressure, m.pressure_pa);
    if (!m.pressure_pa) put(Quantity::depth, m.depth_m);
  }
  void operator()(const BottomVelocity& m) const {
    if (m.velocity) put(Quantity::bottom_x, *m.velocity);
  }
  void operator()(const WaterSpeed& m) const {
    put(Quantity::log_x, m.longitudinal_mps);
    put(Quantity::log_y, m.transverse_mps);
  }
  void operator()(const GnssFix& m) const {
    if (m.position) {
      if (!home) home = m.position;
      constexpr double earth_m = 6'371'000;
      const double east =
          std::remainder(m.position->longitude_rad - home->longitude_rad, 2 * std::numbers::pi);
      put(Quantity::north, earth_m * (m.position->latitude_rad - home->latitude_rad));
      put(Quantity::east, earth_m * std::cos(home->latitude_rad) * east);
    }
    if (m.velocity_ned) put(Quantity::velocity_north, *m.velocity_ned);
    if (!m.velocity_ned) put(Quantity::ground_speed, m.ground_speed_mps);
  }
  void operator()(const GnssSatellites&) const {}
  void operator()(const ActuatorState& m) const {
    put(Quantity::rudder, m.rudder_rad);
    put(Quantity::stern_plane, m.stern_plane_rad);
    put(Quantity::bow_plane, m.bow_plane_rad);
    put(Quantity::shaft, m.propeller_radps);
  }
  void operator()(const AttitudeSample& m) const {
    put(Quantity::heading, m.heading_rad);
    put(Quantity::roll, m.roll_rad);
    put(Quantity::pitch, m.pitch_rad);
    put(Quantity::turn_rate, m.rate_of_turn_radps);
  }
};

std::uint32_t bits(std::initializer_list<bool> present) {
  std::uint32_t all = 0;
  for (const bool one : present) all = all << 1 | (one ? 1U : 0U);
  return all;
}

struct StreamKey {
  std::uint32_t operator()(const DepthSample& m) const {
    return bits({m.depth_m.has_value(), m.pressure_pa.has_value(), m.temperature_k.has_value()});
  }
  std::uint32_t operator()(const WaterSpeed& m) const {
    return bits({m.longitudinal_mps.has_value(), m.distance_m.has_value()});
  }
  std::uint32_t operator()(const ActuatorState& m) const {
    return bits({m.rudder_rad.has_value(), m.stern_plane_rad.has_value(),
                 m.bow_plane_rad.has_value(), m.propeller_radps.has_value()});
  }
  std::uint32_t operator()(const AttitudeSample& m) const {
    return bits({m.heading_rad.has_value(), m.true_heading_rad.has_value(), m.roll_rad.has_value(),
                 m.rate_of_turn_radps.has_value(), m.variation_rad.has_value()});
  }
  template <class Other>
  std::uint32_t operator()(const Other&) const {
    return 0;
  }
};

}  // namespace

const QuantityFacts& facts_of(Quantity quantity) {
  return facts[static_cast<std::size_t>(quantity)];
}

Readings readings_of(const Measurement& measurement, std::optional<Geodetic>& home) {
  Readings readings;
  std::visit(Reader{readings, home}, measurement);
  return readings;
}

std::uint32_t stream_of(const Measurement& measurement) {
  return static_cast<std::uint32_t>(measurement.index()) << 8 |
         std::visit(StreamKey{}, measurement);
}

}  // namespace drydock::diagnosis
