#include "drivers/device/described/measure.hpp"

#include <cmath>
#include <numbers>

#include "drivers/device/dvl/velocity_accuracy.hpp"
#include "drivers/measurement/stamp.hpp"

namespace drydock::device {
namespace {

using measurement::Origin;
using wire::described::Readings;
using wire::described::Target;
using enum wire::described::Target;

constexpr double oldest_s = 10;  ///< an age beyond it is that of clocks that were set

constexpr double day_s = 86400;

/// The time of a clock; a time of day is one since 1970, if the message has the date. Empty: the
/// message does not say, or says what no clock shows, which is seconds since 1970 of 32 bits.
std::optional<std::chrono::nanoseconds> clock_time(const Readings& r, Target of) {
  const auto time_s = r.get(of);
  if (!time_s || !(*time_s >= 0 && *time_s < 4294967296.0)) return {};
  const auto midnight = *time_s <= day_s ? r.get(date).value_or(0) : 0;  // apart, to the nanosecond
  return measurement::from_seconds(midnight) + measurement::from_seconds(*time_s);
}

std::optional<Eigen::Vector3d> vector_of(const Readings& r, Target x, Target y, Target z) {
  if (!r.has(x) || !r.has(y) || !r.has(z)) return {};
  return Eigen::Vector3d(*r.get(x), *r.get(y), *r.get(z));
}

constexpr Target next(Target first, int steps) {
  return static_cast<Target>(static_cast<int>(first) + steps);
}

measurement::DepthSample depth_sample(const Readings& r, const DriverOptions& options) {
  measurement::DepthSample m;
  m.pressure_pa = r.get(pressure);
  if (const auto at_sea = r.get(sea_pressure); at_sea && !m.pressure_pa)
    m.pressure_pa = *at_sea + options.water.surface_pressure_pa;
  m.depth_m = r.get(depth);
  if (!m.depth_m && m.pressure_pa) m.depth_m = options.water.depth_m(*m.pressure_pa);
  m.temperature_k = r.get(temperature);
  m.altitude_m = r.get(altitude);
  return m;
}

/// In the DVL's axes. Empty unless all nine came and each variance is above 0.
std::optional<Eigen::Matrix3d> covariance(const Readings& r) {
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 9; ++i) {
    const auto entry = r.get(next(covariance_xx, i));
    if (!entry) return {};
    matrix(i / 3, i % 3) = *entry;
  }
  return matrix.diagonal().minCoeff() > 0 ? std::optional(matrix) : std::nullopt;
}

measurement::BottomVelocity bottom_velocity(const Readings& r, const DriverOptions& options) {
  measurement::BottomVelocity m;
  if (const auto v = vector_of(r, forward, starboard, down)) {
    m.velocity = options.mounting.to_body(*v);
    m.figure_of_merit_mps = merit_of(r.get(figure_of_merit));
    if (const auto c = covariance(r))
      m.velocity_covariance = options.mounting.covariance_to_body(*c);
  }
  m.error_velocity_mps = r.get(error_velocity);
  m.altitude_m = r.get(altitude);
  for (int beam = 0; beam < 4; ++beam)
    m.range_m[static_cast<std::size_t>(beam)] = r.get(next(range_1, beam));
  m.heading_rad = r.get(heading);
  m.pitch_rad = r.get(pitch);
  m.roll_rad = r.get(roll);
  m.sound_speed_mps = r.get(sound_speed);
  return m;
}

/// The driver turns the speeds.
measurement::WaterSpeed water_speed(const Readings& r) {
  measurement::WaterSpeed m;
  m.distance_m = r.get(distance);
  return m;
}

/// Some count longitudes from 0 to 360 degrees.
double in_half_turns(double longitude_rad) {
  constexpr double half_turn = std::numbers::pi;
  return std::abs(longitude_rad) <= half_turn ? longitude_rad
                                              : std::remainder(longitude_rad, 2 * half_turn);
}

measurement::GnssFix gnss_fix(const Readings& r) {
  measurement::GnssFix m;
  const bool on_earth = std::abs(r.get(latitude).value_or(9)) <= std::numbers::pi / 2;
  if (on_earth && r.has(longitude)) {
    m.position = {*r.get(latitude), in_half_turns(*r.get(longitude))};
    m.type = measurement::FixType::three_d;
  }
  m.ellipsoidal_height_m = r.get(ellipsoidal_height);
  m.mean_sea_level_height_m = r.get(sea_level_height);
  m.velocity_ned = vector_of(r, north, east, down);
  m.ground_speed_mps = r.get(ground_speed);
  m.course_rad = r.get(course);
  m.horizontal_accuracy_m = r.get(horizontal_accuracy);
  m.vertical_accuracy_m = r.get(vertical_accuracy);
  m.speed_accuracy_mps = r.get(speed_accuracy);
  m.position_dop = r.get(dilution);
  if (const auto used = r.get(satellites_used); used && *used >= 0 && *used < 256)
    m.satellites_used = static_cast<int>(*used);
  if (const auto since_1970 = clock_time(r, utc)) m.utc = measurement::Stamp{*since_1970};
  return m;
}

measurement::ActuatorState actuator_state(const Readings& r) {
  measurement::ActuatorState m;
  m.rudder_rad = r.get(rudder);
  m.stern_plane_rad = r.get(stern_plane);
  m.bow_plane_rad = r.get(bow_plane);
  m.propeller_radps = r.get(propeller);
  return m;
}

measurement::ImuSample imu_sample(const Readings& r, const DriverOptions& options) {
  measurement::ImuSample m;
  m.specific_force = options.mounting.to_body(*vector_of(r, force_x, force_y, force_z));
  m.angular_rate = options.mounting.to_body(*vector_of(r, rate_x, rate_y, rate_z));
  return m;
}

template <class Sample>
measurement::Measurement from(Sample sample, const Origin& origin) {
  sample.origin = origin;
  return sample;
}

}  // namespace

std::optional<std::chrono::nanoseconds> device_time_of(const Readings& readings) {
  return clock_time(readings, readings.has(time) ? time : valid_at);
}

measurement::Measurement measurement_of(const Readings& readings, const Origin& origin,
                                        const DriverOptions& options) {
  switch (options.kind) {
    case Kind::depth: return from(depth_sample(readings, options), origin);
    case Kind::dvl: return from(bottom_velocity(readings, options), origin);
    case Kind::emlog: return from(water_speed(readings), origin);
    case Kind::gnss: return from(gnss_fix(readings), origin);
    case Kind::actuator: return from(actuator_state(readings), origin);
    case Kind::attitude:  // its driver turns it, with the tilt of the last sample
    case Kind::imu: break;
  }
  return from(imu_sample(readings, options), origin);
}

std::optional<std::chrono::nanoseconds> age_of(const Readings& readings) {
  auto age_s = readings.get(age);
  const auto valid_s = readings.get(valid_at), sent_s = readings.get(sent_at);
  if (!age_s && valid_s && sent_s) age_s = *sent_s - *valid_s;
  if (age_s && *age_s < -day_s / 2) *age_s += day_s;  // midnight came between the two
  if (!age_s || !(*age_s >= 0 && *age_s <= oldest_s)) return {};
  return measurement::from_seconds(*age_s);
}

}  // namespace drydock::device
