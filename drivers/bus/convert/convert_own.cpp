#include <algorithm>

#include "drivers/bus/convert/convert.hpp"

namespace drydock::bus {
namespace {

/// Sets the header and the device time. Every message type of Drydock begins with them.
template <class Message>
void fill_origin(Message& message, const Origin& origin) {
  message.header.stamp = to_time(origin.valid_at);
  message.device_time = to_optional_time(origin.device_time);
}

template <class Message>
void read_origin(Origin& origin, const Message& message) {
  origin.valid_at = to_stamp(message.header.stamp);
  origin.device_time = to_nanoseconds(message.device_time);
}

Vector3Message vector_or_nan(const std::optional<Eigen::Vector3d>& v) {
  return to_vector3(v.value_or(Eigen::Vector3d::Constant(not_available)));
}

std::optional<Eigen::Matrix3d> to_optional_matrix(const double (&by_rows)[9]) {
  const Eigen::Matrix3d matrix =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(by_rows);
  return matrix.allFinite() ? std::optional(matrix) : std::nullopt;
}

/// 0 is "not told".
std::uint8_t to_number(const std::optional<FixQuality>& quality) {
  return quality ? static_cast<std::uint8_t>(static_cast<std::uint8_t>(*quality) + 1) : 0;
}

std::optional<std::chrono::nanoseconds> since_epoch(std::optional<Stamp> stamp) {
  return stamp ? std::optional(stamp->time_since_epoch()) : std::nullopt;
}

}  // namespace

bool fill(DepthMessage& message, const DepthSample& sample) {
  fill_origin(message, sample.origin);
  message.depth = or_nan(sample.depth_m);
  message.pressure = or_nan(sample.pressure_pa);
  message.temperature = or_nan(sample.temperature_k);
  message.altitude = or_nan(sample.altitude_m);
  return true;
}

bool read(DepthSample& sample, const DepthMessage& message) {
  read_origin(sample.origin, message);
  sample.depth_m = to_optional(message.depth);
  sample.pressure_pa = to_optional(message.pressure);
  sample.temperature_k = to_optional(message.temperature);
  sample.altitude_m = to_optional(message.altitude);
  return true;
}

bool fill(BottomTrackMessage& message, const BottomVelocity& sample) {
  fill_origin(message, sample.origin);
  message.velocity = vector_or_nan(sample.velocity);
  message.error_velocity = or_nan(sample.error_velocity_mps);
  message.altitude = or_nan(sample.altitude_m);
  std::ranges::transform(sample.range_m, message.range, or_nan);
  message.heading = or_nan(sample.heading_rad);
  message.pitch = or_nan(sample.pitch_rad);
  message.roll = or_nan(sample.roll_rad);
  message.sound_speed = or_nan(sample.sound_speed_mps);
  put_by_rows(message.velocity_covariance,
              sample.velocity_covariance.value_or(Eigen::Matrix3d::Constant(not_available)));
  message.figure_of_merit = or_nan(sample.figure_of_merit_mps);
  return true;
}

bool read(BottomVelocity& sample, const BottomTrackMessage& message) {
  read_origin(sample.origin, message);
  sample.velocity = to_optional(message.velocity);
  sample.error_velocity_mps = to_optional(message.error_velocity);
  sample.altitude_m = to_optional(message.altitude);
  std::ranges::transform(message.range, sample.range_m.begin(),
                         [](double range) { return to_optional(range); });
  sample.heading_rad = to_optional(message.heading);
  sample.pitch_rad = to_optional(message.pitch);
  sample.roll_rad = to_optional(message.roll);
  sample.sound_speed_mps = to_optional(message.sound_speed);
  sample.velocity_covariance = to_optional_matrix(message.velocity_covariance);
  sample.figure_of_merit_mps = to_optional(message.figure_of_merit);
  return true;
}

bool fill(WaterSpeedMessage& message, const WaterSpeed& sample) {
  fill_origin(message, sample.origin);
  message.longitudinal = or_nan(sample.longitudinal_mps);
  message.transverse = or_nan(sample.transverse_mps);
  message.distance = or_nan(sample.distance_m);
  message.sigma = or_nan(sample.sigma_mps);
  return true;
}

bool read(WaterSpeed& sample, const WaterSpeedMessage& message) {
  read_origin(sample.origin, message);
  sample.longitudinal_mps = to_optional(message.longitudinal);
  sample.transverse_mps = to_optional(message.transverse);
  sample.distance_m = to_optional(message.distance);
  sample.sigma_mps = to_optional(message.sigma);
  return true;
}

bool fill(GnssFixMessage& message, const GnssFix& sample) {
  fill_origin(message, sample.origin);
  message.fix_type = static_cast<std::uint8_t>(sample.type);
  message.utc = to_optional_time(since_epoch(sample.utc));
  message.latitude = sample.position ? sample.position->latitude_rad : not_available;
  message.longitude = sample.position ? sample.position->longitude_rad : not_available;
  message.ellipsoidal_height = or_nan(sample.ellipsoidal_height_m);
  message.mean_sea_level_height = or_nan(sample.mean_sea_level_height_m);
  message.velocity_ned = vector_or_nan(sample.velocity_ned);
  message.horizontal_accuracy = or_nan(sample.horizontal_accuracy_m);
  message.vertical_accuracy = or_nan(sample.vertical_accuracy_m);
  message.speed_accuracy = or_nan(sample.speed_accuracy_mps);
  message.position_dop = or_nan(sample.position_dop);
  message.satellites_used = sample.satellites_used.value_or(-1);
  message.ground_speed = or_nan(sample.ground_speed_mps);
  message.course = or_nan(sample.course_rad);
  message.quality = to_number(sample.quality);
  return true;
}

bool read(GnssFix& sample, const GnssFixMessage& message) {
  if (message.fix_type > static_cast<std::uint8_t>(FixType::time_only)) return false;
  if (message.quality > to_number(FixQuality::dead_reckoning)) return false;
  read_origin(sample.origin, message);
  sample.type = static_cast<FixType>(message.fix_type);
  if (const auto utc = to_nanoseconds(message.utc)) sample.utc = Stamp{*utc};
  if (std::isfinite(message.latitude) && std::isfinite(message.longitude)) {
    sample.position = {message.latitude, message.longitude};
  }
  sample.ellipsoidal_height_m = to_optional(message.ellipsoidal_height);
  sample.mean_sea_level_height_m = to_optional(message.mean_sea_level_height);
  sample.velocity_ned = to_optional(message.velocity_ned);
  sample.horizontal_accuracy_m = to_optional(message.horizontal_accuracy);
  sample.vertical_accuracy_m = to_optional(message.vertical_accuracy);
  sample.speed_accuracy_mps = to_optional(message.speed_accuracy);
  sample.position_dop = to_optional(message.position_dop);
  if (message.satellites_used >= 0) sample.satellites_used = message.satellites_used;
  sample.ground_speed_mps = to_optional(message.ground_speed);
  sample.course_rad = to_optional(message.course);
  if (message.quality > 0) sample.quality = static_cast<FixQuality>(message.quality - 1);
  return true;
}

bool fill(GnssSatellitesMessage& message, const GnssSatellites& sample) {
  fill_origin(message, sample.origin);
  auto& sequence = message.satellites;
  if (sequence._buffer == nullptr) {
    sequence._maximum = static_cast<std::uint32_t>(sample.satellites.capacity());
    sequence._buffer = static_cast<drydock_msg_dds__Satellite_*>(
        dds_alloc(sequence._maximum * sizeof(drydock_msg_dds__Satellite_)));
    sequence._release = true;
  }
  sequence._length = static_cast<std::uint32_t>(sample.satellites.size());
  std::ranges::transform(sample.satellites, sequence._buffer, [](const Satellite& satellite) {
    return drydock_msg_dds__Satellite_{static_cast<std::uint8_t>(satellite.constellation),
                                       satellite.number,
                                       satellite.used,
                                       or_nan(satellite.cno_dbhz),
                                       or_nan(satellite.elevation_rad),
                                       or_nan(satellite.azimuth_rad)};
  });
  return true;
}

bool read(GnssSatellites& sample, const GnssSatellitesMessage& message) {
  if (message.satellites._length > sample.satellites.capacity()) return false;
  read_origin(sample.origin, message);
  for (std::uint32_t i = 0; i < message.satellites._length; ++i) {
    const auto& from = message.satellites._buffer[i];
    if (from.constellation > static_cast<std::uint8_t>(Constellation::navic)) return false;
    sample.satellites.push_back({static_cast<Constellation>(from.constellation), from.number,
                                 to_optional(from.cno_dbhz), to_optional(from.elevation),
                                 to_optional(from.azimuth), from.used});
  }
  return true;
}

bool fill(AttitudeMessage& message, const AttitudeSample& sample) {
  fill_origin(message, sample.origin);
  message.heading = or_nan(sample.heading_rad);
  message.heading_reference = static_cast<std::uint8_t>(sample.reference);
  message.deviation = or_nan(sample.deviation_rad);
  message.variation = or_nan(sample.variation_rad);
  message.true_heading = or_nan(sample.true_heading_rad);
  message.roll = or_nan(sample.roll_rad);
  message.pitch = or_nan(sample.pitch_rad);
  message.rate_of_turn = or_nan(sample.rate_of_turn_radps);
  return true;
}

bool read(AttitudeSample& sample, const AttitudeMessage& message) {
  if (message.heading_reference > static_cast<std::uint8_t>(HeadingReference::magnetic_north))
    return false;
  read_origin(sample.origin, message);
  sample.heading_rad = to_optional(message.heading);
  sample.reference = static_cast<HeadingReference>(message.heading_reference);
  sample.deviation_rad = to_optional(message.deviation);
  sample.variation_rad = to_optional(message.variation);
  sample.true_heading_rad = to_optional(message.true_heading);
  sample.roll_rad = to_optional(message.roll);
  sample.pitch_rad = to_optional(message.pitch);
  sample.rate_of_turn_radps = to_optional(message.rate_of_turn);
  return true;
}

bool fill(ActuatorStateMessage& message, const ActuatorState& sample) {
  fill_origin(message, sample.origin);
  message.rudder = or_nan(sample.rudder_rad);
  message.stern_plane = or_nan(sample.stern_plane_rad);
  message.bow_plane = or_nan(sample.bow_plane_rad);
  message.propeller = or_nan(sample.propeller_radps);
  return true;
}

bool read(ActuatorState& sample, const ActuatorStateMessage& message) {
  read_origin(sample.origin, message);
  sample.rudder_rad = to_optional(message.rudder);
  sample.stern_plane_rad = to_optional(message.stern_plane);
  sample.bow_plane_rad = to_optional(message.bow_plane);
  sample.propeller_radps = to_optional(message.propeller);
  return true;
}

}  // namespace drydock::bus
