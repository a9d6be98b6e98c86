#include "hil/scorecard/field.hpp"

#include <array>

namespace drydock::scorecard {
namespace {

using namespace measurement;

class Fields {
 public:
  Fields(Stamp start, std::vector<Field>& out) : start_(start), out_(out) {}

  void operator()(const ImuSample& m) {
    put(0, forces, m.specific_force);
    put(3, rates, m.angular_rate);
  }
  void operator()(const DepthSample& m) {
    put(0, "depth_m", m.depth_m);
    put(1, "pressure_pa", m.pressure_pa);
    put(2, "temperature_k", m.temperature_k);
    put(3, "altitude_m", m.altitude_m);
  }
  void operator()(const BottomVelocity& m) {
    if (m.velocity) put(0, velocities, *m.velocity);
    put(3, "altitude_m", m.altitude_m);
    for (std::uint32_t i = 0; i < m.range_m.size(); ++i) put(4 + i, "range_m", m.range_m.at(i));
    put(8, "heading_rad", m.heading_rad, Role::value, true);
    put(9, "pitch_rad", m.pitch_rad, Role::value, true);
    put(10, "roll_rad", m.roll_rad, Role::value, true);
    put(11, "sound_speed_mps", m.sound_speed_mps);
    put(12, "error_velocity_mps", m.error_velocity_mps, Role::quality);
  }
  void operator()(const WaterSpeed& m) {
    put(0, "longitudinal_mps", m.longitudinal_mps);
    put(1, "transverse_mps", m.transverse_mps);
    put(2, "distance_m", m.distance_m, Role::total);
  }
  void operator()(const GnssFix& m) {
    if (m.position) {
      put(0, "latitude_rad", m.position->latitude_rad, Role::value, true);
      put(1, "longitude_rad", m.position->longitude_rad, Role::value, true);
    }
    put(2, "ellipsoidal_height_m", m.ellipsoidal_height_m);
    put(3, "mean_sea_level_height_m", m.mean_sea_level_height_m);
    if (m.velocity_ned) put(4, velocities, *m.velocity_ned);
    put(7, "ground_speed_mps", m.ground_speed_mps);
    put(8, "course_rad", m.course_rad, Role::value, true);
    put(9, "horizontal_accuracy_m", m.horizontal_accuracy_m, Role::quality);
    put(10, "vertical_accuracy_m", m.vertical_accuracy_m, Role::quality);
    put(11, "speed_accuracy_mps", m.speed_accuracy_mps, Role::quality);
    put(12, "position_dop", m.position_dop, Role::quality);
    if (m.satellites_used) put(13, "satellites_used", double(*m.satellites_used), Role::quality);
    if (m.utc) put(14, "utc", seconds(*m.utc - start_), Role::clock);
  }
  void operator()(const GnssSatellites& m) {
    for (const Satellite& satellite : m.satellites) {
      const std::uint32_t first =
          first_of_satellites +
          (static_cast<std::uint32_t>(satellite.constellation) << 8 | satellite.number) * 4;
      put(first, "cno_dbhz", satellite.cno_dbhz, Role::quality);
      put(first + 1, "elevation_rad", satellite.elevation_rad);
      put(first + 2, "azimuth_rad", satellite.azimuth_rad, Role::value, true);
    }
  }
  void operator()(const ActuatorState& m) {
    put(0, "rudder_rad", m.rudder_rad);
    put(1, "stern_plane_rad", m.stern_plane_rad);
    put(2, "bow_plane_rad", m.bow_plane_rad);
    put(3, "propeller_radps", m.propeller_radps);
  }
  void operator()(const AttitudeSample& m) {
    put(0, "heading_rad", m.heading_rad, Role::value, true);
    put(1, "roll_rad", m.roll_rad, Role::value, true);
    put(2, "pitch_rad", m.pitch_rad, Role::value, true);
    put(3, "rate_of_turn_radps", m.rate_of_turn_radps);
    put(4, "deviation_rad", m.deviation_rad);
    put(5, "variation_rad", m.variation_rad);
    put(6, "true_heading_rad", m.true_heading_rad, Role::value, true);
  }

 private:
  using Names = std::array<std::string_view, 3>;
  static constexpr Names forces{"specific_force.x", "specific_force.y", "specific_force.z"};
  static constexpr Names rates{"angular_rate.x", "angular_rate.y", "angular_rate.z"};
  static constexpr Names velocities{"velocity.x", "velocity.y", "velocity.z"};
  static constexpr std::uint32_t first_of_satellites = 64;

  void put(std::uint32_t series, std::string_view name, std::optional<double> value,
           Role role = Role::value, bool angle = false) {
    if (value) out_.push_back({series, name, *value, role, angle});
  }
  void put(std::uint32_t first, const Names& names, const Eigen::Vector3d& v) {
    for (std::uint32_t i = 0; i < 3; ++i) put(first + i, names.at(i), v[static_cast<int>(i)]);
  }

  Stamp start_;
  std::vector<Field>& out_;
};

}  // namespace

void fields_of(const Measurement& m, Stamp start, std::vector<Field>& out) {
  out.clear();
  std::visit(Fields(start, out), m);
}

}  // namespace drydock::scorecard
