#pragma once

#include "drivers/measurement/measurement.hpp"
#include "drivers/wire/fields.hpp"

/// Names of the measurements and of their fields, for JSON. Angles are in degrees.
namespace drydock::measurement {

constexpr std::string_view type_of(const ImuSample&) { return "imu"; }
constexpr std::string_view type_of(const DepthSample&) { return "depth"; }
constexpr std::string_view type_of(const BottomVelocity&) { return "bottom_velocity"; }
constexpr std::string_view type_of(const WaterSpeed&) { return "water_speed"; }
constexpr std::string_view type_of(const GnssFix&) { return "gnss_fix"; }
constexpr std::string_view type_of(const GnssSatellites&) { return "gnss_satellites"; }
constexpr std::string_view type_of(const ActuatorState&) { return "actuator_state"; }
constexpr std::string_view type_of(const AttitudeSample&) { return "attitude_sample"; }

template <class Field>
void visit_fields(const ImuSample& m, Field&& field) {
  field("specific_force_mps2", m.specific_force);
  field("angular_rate_degps", Eigen::Vector3d(m.angular_rate * wire::degrees(1)));
}

template <class Field>
void visit_fields(const DepthSample& m, Field&& field) {
  field("depth_m", m.depth_m);
  field("pressure_pa", m.pressure_pa);
  field("temperature_k", m.temperature_k);
  field("altitude_m", m.altitude_m);
}

/// One standard deviation of each axis.
inline std::optional<Eigen::Vector3d> sigmas_of(const std::optional<Eigen::Matrix3d>& covariance) {
  if (!covariance) return {};
  return covariance->diagonal().cwiseSqrt();
}

template <class Field>
void visit_fields(const BottomVelocity& m, Field&& field) {
  field("velocity_mps", m.velocity);
  field("error_velocity_mps", m.error_velocity_mps);
  field("altitude_m", m.altitude_m);
  field("range_m", m.range_m);
  field("heading_deg", wire::degrees(m.heading_rad));
  field("pitch_deg", wire::degrees(m.pitch_rad));
  field("roll_deg", wire::degrees(m.roll_rad));
  field("sound_speed_mps", m.sound_speed_mps);
  field("depth_m", m.depth_m);
  field("water_temperature_k", m.water_temperature_k);
  field("salinity_ppt", m.salinity_ppt);
  field("velocity_sigma_mps", sigmas_of(m.velocity_covariance));
  field("figure_of_merit_mps", m.figure_of_merit_mps);
}

template <class Field>
void visit_fields(const WaterSpeed& m, Field&& field) {
  field("longitudinal_mps", m.longitudinal_mps);
  field("transverse_mps", m.transverse_mps);
  field("distance_m", m.distance_m);
  field("sigma_mps", m.sigma_mps);
}

template <class Field>
void visit_fields(const GnssFix& m, Field&& field) {
  using Angle = std::optional<double>;
  constexpr std::array<std::string_view, 5> qualities{"autonomous", "differential", "rtk_float",
                                                      "rtk_fixed", "dead_reckoning"};
  field("fix_type", static_cast<int>(m.type));
  field("quality", m.quality ? qualities[static_cast<std::size_t>(*m.quality)] : "unknown");
  field("utc_s", m.utc ? Angle(seconds(m.utc->time_since_epoch())) : Angle());
  field("latitude_deg", m.position ? Angle(wire::degrees(m.position->latitude_rad)) : Angle());
  field("longitude_deg", m.position ? Angle(wire::degrees(m.position->longitude_rad)) : Angle());
  field("ellipsoidal_height_m", m.ellipsoidal_height_m);
  field("mean_sea_level_height_m", m.mean_sea_level_height_m);
  field("velocity_ned_mps", m.velocity_ned);
  field("horizontal_accuracy_m", m.horizontal_accuracy_m);
  field("vertical_accuracy_m", m.vertical_accuracy_m);
  field("speed_accuracy_mps", m.speed_accuracy_mps);
  field("position_dop", m.position_dop);
  field("satellites_used", m.satellites_used);
  field("ground_speed_mps", m.ground_speed_mps);
  field("course_deg", wire::degrees(m.course_rad));
}

template <class Field>
void visit_fields(const Satellite& m, Field&& field) {
  constexpr std::array<std::string_view, 8> names{"gps",  "sbas", "galileo", "beidou",
                                                  "imes", "qzss", "glonass", "navic"};
  field("gnss", names[static_cast<std::size_t>(m.constellation)]);
  field("number", m.number);
  field("cno_dbhz", m.cno_dbhz);
  field("elevation_deg", wire::degrees(m.elevation_rad));
  field("azimuth_deg", wire::degrees(m.azimuth_rad));
  field("used", m.used);
}

template <class Field>
void visit_fields(const GnssSatellites& m, Field&& field) {
  field("satellites", m.satellites);
}

template <class Field>
void visit_fields(const ActuatorState& m, Field&& field) {
  field("rudder_deg", wire::degrees(m.rudder_rad));
  field("stern_plane_deg", wire::degrees(m.stern_plane_rad));
  field("bow_plane_deg", wire::degrees(m.bow_plane_rad));
  field("propeller_radps", m.propeller_radps);
}

template <class Field>
void visit_fields(const AttitudeSample& m, Field&& field) {
  constexpr std::array<std::string_view, 3> references{"unknown", "true", "magnetic"};
  field("heading_deg", wire::degrees(m.heading_rad));
  field("reference", references[static_cast<std::size_t>(m.reference)]);
  field("deviation_deg", wire::degrees(m.deviation_rad));
  field("variation_deg", wire::degrees(m.variation_rad));
  field("true_heading_deg", wire::degrees(m.true_heading_rad));
  field("roll_deg", wire::degrees(m.roll_rad));
  field("pitch_deg", wire::degrees(m.pitch_rad));
  field("rate_of_turn_degps", wire::degrees(m.rate_of_turn_radps));
}

}  // namespace drydock::measurement
