#pragma once

#include <algorithm>
#include <limits>
#include <optional>

#include "drivers/wire/fields.hpp"
#include "drivers/wire/mavlink/autopilot_messages.hpp"

/// The fields of the messages for people and scripts: fields.hpp. Null: the sender says that it
/// does not know the value.
namespace drydock::wire::mavlink {

template <class F>
void visit_sender(const Sender& sender, F&& field) {
  field("system", sender.system);
  field("component", sender.component);
  field("sequence", sender.sequence);
}

/// A number of the wire over how many make a unit; empty for the number that stands for "not
/// known".
template <class Number>
std::optional<double> unless(Number none, Number number, double to_a_unit) {
  return number == none ? std::nullopt : std::optional{number / to_a_unit};
}

inline double degrees_of(std::int32_t e7) { return e7 / 1e7; }
inline constexpr std::uint16_t no_u16 = std::numeric_limits<std::uint16_t>::max();

template <class F>
void visit_fields(const Heartbeat& m, F&& field) {
  visit_sender(m.sender, field);
  field("vehicle", m.vehicle);
  field("autopilot", m.autopilot);
  field("base_mode", m.base_mode);
  field("custom_mode", m.custom_mode);
  field("system_status", m.system_status);
}

template <class F>
void visit_fields(const Timesync& m, F&& field) {
  visit_sender(m.sender, field);
  field("tc1_ns", m.tc1.count());
  field("ts1_ns", m.ts1.count());
  field("target_system", m.target_system);
  field("target_component", m.target_component);
}

template <class F>
void visit_fields(const Odometry& m, F&& field) {
  visit_sender(m.sender, field);
  field("time_s", seconds(m.time));
  field("frame", m.frame);
  field("child_frame", m.child_frame);
  field("position_m", m.position_m);
  field("quaternion_wxyz", m.attitude);
  field("velocity_mps", m.velocity_mps);
  field("rates_radps", m.rates_radps);
  field("pose_covariance", m.pose_covariance);
  field("velocity_covariance", m.velocity_covariance);
  field("reset_counter", m.reset_counter);
  field("estimator_type", m.estimator_type);
  field("quality_percent", m.quality);
}

template <class F>
void visit_fields(const VisionPositionDelta& m, F&& field) {
  visit_sender(m.sender, field);
  field("time_s", seconds(m.time));
  field("time_delta_s", seconds(m.time_delta));
  field("angle_rad", m.angle_rad);
  field("position_m", m.position_m);
  field("confidence", m.confidence);
}

template <class F>
void visit_fields(const SystemTime& m, F&& field) {
  visit_sender(m.sender, field);
  field("time_unix_s", seconds(m.time_unix));
  field("time_s", seconds(m.time));
}

template <class F>
void visit_fields(const GpsRawInt& m, F&& field) {
  visit_sender(m.sender, field);
  field("time_s", seconds(m.time));
  field("fix_type", m.fix_type);
  field("satellites", unless<std::uint8_t>(255, m.satellites, 1));
  field("latitude_deg", degrees_of(m.latitude_e7));
  field("longitude_deg", degrees_of(m.longitude_e7));
  field("height_m", m.height_mm / 1e3);
  field("horizontal_dop", unless(no_u16, m.hdop_e2, 1e2));
  field("vertical_dop", unless(no_u16, m.vdop_e2, 1e2));
  field("speed_mps", unless(no_u16, m.speed_cmps, 1e2));
  field("course_deg", unless(no_u16, m.course_cdeg, 1e2));
  field("ellipsoidal_height_m", m.ellipsoidal_height_mm / 1e3);
  field("horizontal_accuracy_m", m.horizontal_accuracy_mm / 1e3);
  field("vertical_accuracy_m", m.vertical_accuracy_mm / 1e3);
  field("speed_accuracy_mps", m.speed_accuracy_mmps / 1e3);
  field("heading_accuracy_deg", m.heading_accuracy_e5 / 1e5);
  field("yaw_deg", unless<std::uint16_t>(0, m.yaw_cdeg, 1e2));
}

template <class F>
void visit_fields(const ScaledPressure& m, F&& field) {
  visit_sender(m.sender, field);
  field("time_s", seconds(m.time));
  field("absolute_hpa", m.absolute_hpa);
  field("differential_hpa", m.differential_hpa);
  field("temperature_degc", m.temperature_cdegc / 1e2);
}

template <class F>
void visit_fields(const Attitude& m, F&& field) {
  visit_sender(m.sender, field);
  field("time_s", seconds(m.time));
  field("roll_deg", degrees(m.roll_rad));
  field("pitch_deg", degrees(m.pitch_rad));
  field("yaw_deg", degrees(m.yaw_rad));
  field("rates_radps", m.rates_radps);
}

template <class F>
void visit_fields(const LocalPositionNed& m, F&& field) {
  visit_sender(m.sender, field);
  field("time_s", seconds(m.time));
  field("position_ned_m", m.position_m);
  field("velocity_ned_mps", m.velocity_mps);
}

template <class F>
void visit_fields(const GlobalPositionInt& m, F&& field) {
  visit_sender(m.sender, field);
  field("time_s", seconds(m.time));
  field("latitude_deg", degrees_of(m.latitude_e7));
  field("longitude_deg", degrees_of(m.longitude_e7));
  field("height_m", m.height_mm / 1e3);
  field("height_above_home_m", m.height_above_home_mm / 1e3);
  field("velocity_ned_mps", std::array{m.north_cmps / 1e2, m.east_cmps / 1e2, m.down_cmps / 1e2});
  field("heading_deg", unless(no_u16, m.heading_cdeg, 1e2));
}

template <class F>
void visit_fields(const VfrHud& m, F&& field) {
  visit_sender(m.sender, field);
  field("fluid_speed_mps", m.fluid_speed_mps);
  field("ground_speed_mps", m.ground_speed_mps);
  field("height_m", m.height_m);
  field("climb_mps", m.climb_mps);
  field("heading_deg", m.heading_deg);
  field("throttle_percent", m.throttle_percent);
}

template <class F>
void visit_fields(const DistanceSensor& m, F&& field) {
  visit_sender(m.sender, field);
  field("time_s", seconds(m.time));
  field("distance_m", m.distance_cm / 1e2);
  field("least_m", m.least_cm / 1e2);
  field("most_m", m.most_cm / 1e2);
  field("kind", m.kind);
  field("number", m.number);
  field("orientation", m.orientation);
  field("variance_m2", unless<std::uint8_t>(255, m.variance_cm2, 1e4));
  field("quality_percent", unless<std::uint8_t>(0, m.quality_percent, 1));
}

template <class F>
void visit_fields(const StatusText& m, F&& field) {
  visit_sender(m.sender, field);
  field("severity", m.severity);
  const auto end = std::ranges::find(m.text, '\0');
  field("text", std::string_view(m.text.data(), static_cast<std::size_t>(end - m.text.begin())));
  field("text_id", m.text_id);
  field("chunk", m.chunk);
}

}  // namespace drydock::wire::mavlink
