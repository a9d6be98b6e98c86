#include "hil/characterize/samples.hpp"

#include <cmath>
#include <limits>

#include "drivers/measurement/head_tilt.hpp"
#include "drivers/measurement/units.hpp"
#include "drivers/measurement/water_column.hpp"
#include "estimators/frame/attitude.hpp"

namespace drydock::characterize {
namespace {

using Eigen::Vector3d;

constexpr double absent = std::numeric_limits<double>::quiet_NaN();

const Vector3d nothing = Vector3d::Constant(absent);

/// Metres from the first fix, on a sphere of the Earth's mean radius. This is good enough for
/// scatter, not for distances.
Vector3d north_east_down(const measurement::Geodetic& here, const measurement::Geodetic& first,
                         double rise_m) {
  constexpr double mean_radius_m = 6'371'009;
  return {(here.latitude_rad - first.latitude_rad) * mean_radius_m,
          frame::wrap_pi(here.longitude_rad - first.longitude_rad) * mean_radius_m *
              std::cos(first.latitude_rad),
          -rise_m};
}

Vector3d velocity_of(const measurement::GnssFix& fix) {
  if (fix.velocity_ned) return *fix.velocity_ned;
  if (!fix.ground_speed_mps || !fix.course_rad) return nothing;
  return {*fix.ground_speed_mps * std::cos(*fix.course_rad),
          *fix.ground_speed_mps * std::sin(*fix.course_rad), absent};
}

Vector3d attitude_of(const measurement::BottomVelocity& dvl) {
  const auto tilt = measurement::head_tilt(dvl);
  if (!dvl.heading_rad || !tilt) return nothing;
  return {tilt->roll_rad, tilt->pitch_rad, *dvl.heading_rad};
}

/// The measured pressure, or the pressure at the measured depth in the rig's default water.
double pressure_of(const measurement::DepthSample& sample) {
  if (sample.pressure_pa) return *sample.pressure_pa;
  if (!sample.depth_m) return absent;
  const measurement::WaterColumn water;
  return water.surface_pressure_pa + *sample.depth_m * water.density_kgm3 * units::standard_gravity;
}

}  // namespace

void Samples::add(const measurement::Measurement& any) {
  const auto put = [this](const measurement::Origin& origin, const Vector3d& primary,
                          const Vector3d& secondary) {
    origins.push_back(origin);
    quantities[0].push_back(primary);
    quantities[1].push_back(secondary);
  };
  const Eigen::Matrix3d to_sensor = subject.sensor_to_body.transpose();
  if (const auto* imu = std::get_if<measurement::ImuSample>(&any)) {
    put(imu->origin, to_sensor * imu->angular_rate, to_sensor * imu->specific_force);
  } else if (const auto* dvl = std::get_if<measurement::BottomVelocity>(&any)) {
    put(dvl->origin, dvl->velocity ? Vector3d(to_sensor * *dvl->velocity) : nothing, nothing);
    attitude.push_back(attitude_of(*dvl));
    sound_speed.add(*dvl);
  } else if (const auto* log = std::get_if<measurement::WaterSpeed>(&any)) {
    put(log->origin,
        {log->longitudinal_mps.value_or(absent), log->transverse_mps.value_or(absent), absent},
        nothing);
  } else if (const auto* depth = std::get_if<measurement::DepthSample>(&any)) {
    put(depth->origin, {pressure_of(*depth), absent, absent}, nothing);
  } else if (const auto* fix = std::get_if<measurement::GnssFix>(&any)) {
    Vector3d position = nothing;
    if (fix->position) {
      const double height = fix->ellipsoidal_height_m.value_or(absent);
      if (!first_position_) {
        first_position_ = fix->position;
        first_height_m_ = height;
      }
      position = north_east_down(*fix->position, *first_position_, height - first_height_m_);
    }
    put(fix->origin, position, velocity_of(*fix));
    if (fix->utc && subject.times == Subject::Times::of_arrival)
      utc_latency_s.push_back(measurement::seconds(fix->origin.received_at - *fix->utc));
  } else if (const auto* actuator = std::get_if<measurement::ActuatorState>(&any)) {
    put(actuator->origin,
        {actuator->rudder_rad.value_or(absent), actuator->stern_plane_rad.value_or(absent),
         actuator->bow_plane_rad.value_or(absent)},
        {actuator->propeller_radps.value_or(absent), absent, absent});
  } else if (const auto* compass = std::get_if<measurement::AttitudeSample>(&any)) {
    const double heading_rad = compass->heading_rad.value_or(absent);
    const double last_rad = heading_rad_.value_or(heading_rad);
    if (std::isfinite(heading_rad))
      heading_rad_ = last_rad + frame::wrap_pi(heading_rad - last_rad);
    put(compass->origin,
        {compass->roll_rad.value_or(absent), compass->pitch_rad.value_or(absent),
         std::isfinite(heading_rad) ? *heading_rad_ : absent},
        {compass->rate_of_turn_radps.value_or(absent), absent, absent});
  }
}

}  // namespace drydock::characterize
