#include <algorithm>

#include "drivers/bus/convert/convert.hpp"
#include "drivers/measurement/axis_sigma.hpp"
#include "drivers/measurement/units.hpp"

namespace drydock::bus {
namespace {

constexpr double celsius_zero_k = 273.15;

/// sensor_msgs/NavSatStatus.
enum NavSatStatus : std::int8_t { no_fix = -1, fix = 0, sbas_fix = 1, gbas_fix = 2 };
enum CovarianceType : std::uint8_t { unknown = 0, approximated = 1 };
constexpr std::uint8_t mode_bottom = 1;
constexpr std::ptrdiff_t fewest_beams_for_velocity = 3;

constexpr double not_measured = -1;  ///< variance that means so in every message that has one

/// A component that was not measured is 0 with variance -1. robot_localization rotates the whole
/// vector before it selects components, so a NaN would destroy the measured components.
void set_twist(TwistMessage& message, const std::array<std::optional<double>, 3>& linear,
               const Eigen::Matrix3d& covariance) {
  std::ranges::fill(message.twist.covariance, 0.0);
  for (int i = 0; i < 6; ++i) message.twist.covariance[i * 7] = not_measured;
  message.twist.twist = {};
  double* const components[] = {&message.twist.twist.linear.x, &message.twist.twist.linear.y,
                                &message.twist.twist.linear.z};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!linear[i]) continue;
    *components[i] = *linear[i];
    for (std::size_t j = 0; j < 3; ++j)
      if (linear[j])
        message.twist.covariance[i * 6 + j] = covariance(Eigen::Index(i), Eigen::Index(j));
  }
}

/// Of three components that have one sigma, m/s, and do not depend on each other. None is exact: a
/// sigma of 0 is not known.
Eigen::Matrix3d covariance_of(const std::optional<double>& sigma) {
  const bool known = sigma && *sigma > 0;
  return (known ? *sigma * *sigma : unknown_variance) * Eigen::Matrix3d::Identity();
}

/// In the body (FRD). A figure of merit is taken as the sigma of each component: that of Water
/// Linked is the root of the covariance's largest eigenvalue, Nortek's a standard deviation.
std::optional<Eigen::Matrix3d> covariance_of(const BottomVelocity& sample) {
  if (sample.velocity_covariance) return sample.velocity_covariance;
  if (!sample.figure_of_merit_mps) return {};
  return covariance_of(sample.figure_of_merit_mps);
}

/// A receiver does not say whether its corrections come from a satellite or from a base. As ROS's
/// nmea_navsat_driver does for GGA, differential is SBAS, and RTK, which needs a base, is GBAS.
NavSatStatus status_of(const GnssFix& sample) {
  if (!sample.position) return no_fix;
  if (sample.quality == FixQuality::differential) return sbas_fix;
  const bool rtk =
      sample.quality == FixQuality::rtk_float || sample.quality == FixQuality::rtk_fixed;
  return rtk ? gbas_fix : fix;
}

std::array<std::optional<double>, 3> components(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

std::optional<double> negated(std::optional<double> value) {
  return value ? std::optional(-*value) : std::nullopt;
}

/// East, north, up. Up is missing if the receiver gave only speed and course.
std::array<std::optional<double>, 3> velocity_enu(const GnssFix& fix) {
  if (fix.velocity_ned) return components(swap_ned_enu(*fix.velocity_ned));
  if (!fix.ground_speed_mps || !fix.course_rad) return {};
  return {*fix.ground_speed_mps * std::sin(*fix.course_rad),
          *fix.ground_speed_mps * std::cos(*fix.course_rad), std::nullopt};
}

}  // namespace

bool fill(ImuMessage& message, const ImuSample& sample) {
  message.header.stamp = to_time(sample.origin.valid_at);
  message.orientation = {0, 0, 0, 1};
  message.orientation_covariance[0] = not_measured;
  message.angular_velocity = to_vector3(half_turn_about_x(sample.angular_rate));
  message.linear_acceleration = to_vector3(half_turn_about_x(sample.specific_force));
  return true;
}

bool read(ImuSample& sample, const ImuMessage& message) {
  sample.origin.valid_at = to_stamp(message.header.stamp);
  sample.angular_rate = half_turn_about_x(to_eigen(message.angular_velocity));
  sample.specific_force = half_turn_about_x(to_eigen(message.linear_acceleration));
  return message.angular_velocity_covariance[0] != not_measured &&
         message.linear_acceleration_covariance[0] != not_measured &&
         sample.angular_rate.allFinite() && sample.specific_force.allFinite();
}

bool fill(DvlMessage& message, const BottomVelocity& sample) {
  constexpr auto nan = std::numeric_limits<float>::quiet_NaN();
  message.header.stamp = to_time(sample.origin.valid_at);
  message.velocity_mode = mode_bottom;
  const auto v = sample.velocity.value_or(Eigen::Vector3d::Constant(not_available));
  message.velocity = to_vector3(v);
  std::ranges::fill(message.velocity_covar, not_measured);  // the definition's "not known"
  if (const auto covariance = sample.velocity ? covariance_of(sample) : std::nullopt)
    put_by_rows(message.velocity_covar, *covariance);
  message.altitude = or_nan(sample.altitude_m);
  message.course_gnd = std::atan2(v.y(), v.x());
  message.speed_gnd = std::hypot(v.x(), v.y());
  const auto ranges =
      std::ranges::count_if(sample.range_m, [](const auto& range) { return range.has_value(); });
  message.num_good_beams = static_cast<std::uint8_t>(
      sample.velocity ? std::max<std::ptrdiff_t>(ranges, fewest_beams_for_velocity) : ranges);
  message.sound_speed = static_cast<float>(or_nan(sample.sound_speed_mps));
  // Ranges along the beams need the angle of the beams. A measurement does not carry that angle.
  message.beam_ranges_valid = false;
  message.beam_velocities_valid = false;
  std::ranges::fill(message.beam_unit_vec,
                    Vector3Message{not_available, not_available, not_available});
  std::ranges::fill(message.range, not_available);
  std::ranges::fill(message.range_covar, float{not_measured});
  std::ranges::fill(message.beam_quality, nan);
  std::ranges::fill(message.beam_velocity, nan);
  std::ranges::fill(message.beam_velocity_covar, float{not_measured});
  return true;
}

bool read(BottomVelocity& sample, const DvlMessage& message) {
  sample.origin.valid_at = to_stamp(message.header.stamp);
  if (message.num_good_beams > 0) {
    sample.velocity = to_optional(message.velocity);
    sample.altitude_m = to_optional(message.altitude);
  }
  if (message.sound_speed > 0) sample.sound_speed_mps = to_optional(double{message.sound_speed});
  return message.velocity_mode == mode_bottom;
}

bool fill(TwistMessage& message, const BottomVelocity& sample) {
  if (!sample.velocity) return false;
  message.header.stamp = to_time(sample.origin.valid_at);
  const Eigen::DiagonalMatrix<double, 3> turn(1, -1, -1);
  set_twist(message, components(half_turn_about_x(*sample.velocity)),
            turn * covariance_of(sample).value_or(covariance_of(std::nullopt)) * turn);
  return true;
}

bool fill(TwistMessage& message, const WaterSpeed& sample) {
  if (!sample.longitudinal_mps && !sample.transverse_mps) return false;
  message.header.stamp = to_time(sample.origin.valid_at);
  set_twist(message, {sample.longitudinal_mps, negated(sample.transverse_mps), std::nullopt},
            covariance_of(sample.sigma_mps));
  return true;
}

bool read(WaterSpeed& sample, const TwistMessage& message) {
  sample.origin.valid_at = to_stamp(message.header.stamp);
  const auto& linear = message.twist.twist.linear;
  if (message.twist.covariance[0] >= 0) sample.longitudinal_mps = to_optional(linear.x);
  if (message.twist.covariance[7] >= 0) sample.transverse_mps = negated(to_optional(linear.y));
  return true;
}

bool fill(TwistMessage& message, const GnssFix& sample) {
  const auto velocity = velocity_enu(sample);
  if (!velocity[0]) return false;
  message.header.stamp = to_time(sample.origin.valid_at);
  set_twist(message, velocity, covariance_of(sample.speed_accuracy_mps));
  return true;
}

bool fill(NavSatFixMessage& message, const GnssFix& sample) {
  message.header.stamp = to_time(sample.origin.valid_at);
  message.status = {status_of(sample), 0};
  message.latitude = message.longitude = not_available;
  if (sample.position) {
    message.latitude = sample.position->latitude_rad * units::degrees_per_radian;
    message.longitude = sample.position->longitude_rad * units::degrees_per_radian;
  }
  message.altitude = or_nan(sample.position ? sample.ellipsoidal_height_m : std::nullopt);
  std::ranges::fill(message.position_covariance, 0.0);
  message.position_covariance_type = unknown;
  const auto axis = measurement::axis_sigma_m(sample);
  if (axis && sample.vertical_accuracy_m) {
    const double vertical = *sample.vertical_accuracy_m;
    message.position_covariance[0] = message.position_covariance[4] = *axis * *axis;
    message.position_covariance[8] = vertical * vertical;
    message.position_covariance_type = approximated;
  }
  return true;
}

bool read(GnssFix& sample, const NavSatFixMessage& message) {
  sample.origin.valid_at = to_stamp(message.header.stamp);
  const auto latitude = to_optional(message.latitude), longitude = to_optional(message.longitude);
  if (message.status.status < fix || !latitude || !longitude) return true;
  sample.position = {*latitude / units::degrees_per_radian, *longitude / units::degrees_per_radian};
  sample.ellipsoidal_height_m = to_optional(message.altitude);
  sample.type = sample.ellipsoidal_height_m ? FixType::three_d : FixType::two_d;
  if (message.position_covariance_type != unknown) {
    sample.horizontal_accuracy_m =
        to_optional(std::sqrt(message.position_covariance[0] + message.position_covariance[4]));
    sample.vertical_accuracy_m = to_optional(std::sqrt(message.position_covariance[8]));
  }
  return true;
}

bool fill(FluidPressureMessage& message, const DepthSample& sample) {
  if (!sample.pressure_pa) return false;
  message.header.stamp = to_time(sample.origin.valid_at);
  message.fluid_pressure = *sample.pressure_pa;
  return true;
}

bool read(DepthSample& sample, const FluidPressureMessage& message) {
  sample.origin.valid_at = to_stamp(message.header.stamp);
  sample.pressure_pa = to_optional(message.fluid_pressure);
  return true;
}

bool fill(TemperatureMessage& message, const DepthSample& sample) {
  if (!sample.temperature_k) return false;
  message.header.stamp = to_time(sample.origin.valid_at);
  message.temperature = *sample.temperature_k - celsius_zero_k;
  return true;
}

}  // namespace drydock::bus
