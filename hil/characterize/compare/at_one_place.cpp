#include "hil/characterize/compare/at_one_place.hpp"

#include <cmath>
#include <numbers>

#include "drivers/measurement/units.hpp"
#include "estimators/frame/attitude.hpp"

namespace drydock::characterize {
namespace {

using Eigen::Vector3d;

constexpr double slowest_mps = 0.5;  ///< below this speed the course is undefined
constexpr double straight_within_radps = 0.5 * units::degree;

/// Angular rate of the vehicle, in body axes.
Track rate_of(const Samples* imu, measurement::Stamp zero) {
  if (imu == nullptr) return {};
  std::vector<Vector3d> rates;
  rates.reserve(imu->origins.size());
  for (const auto& rate : imu->quantities[0])
    rates.emplace_back(imu->subject.sensor_to_body * rate);
  return {*imu, rates, zero};
}

/// Unwraps the heading, so that it can be interpolated.
std::vector<Vector3d> unwrapped(std::vector<Vector3d> attitude) {
  double last = 0;
  for (auto& angles : attitude) {
    if (!angles.allFinite()) continue;
    last += std::remainder(angles.z() - last, 2 * std::numbers::pi);
    angles.z() = last;
  }
  return attitude;
}

/// A receiver of NMEA 0183 tells no vertical velocity: at the surface it is taken as none.
std::vector<Vector3d> over_ground_of(const Samples& gnss) {
  std::vector<Vector3d> velocities = gnss.quantities[1];
  for (auto& velocity : velocities)
    if (std::isnan(velocity.z()) && velocity.head<2>().allFinite()) velocity.z() = 0;
  return velocities;
}

std::optional<double> course_of(const Vector3d& velocity_ned) {
  if (velocity_ned.head<2>().norm() < slowest_mps) return std::nullopt;
  return std::atan2(velocity_ned.y(), velocity_ned.x());
}

}  // namespace

AtOnePlace::AtOnePlace(const Samples& dvl, const Samples& gnss, const Samples* imu)
    : body_to_sensor_(dvl.subject.sensor_to_body.transpose()),
      arm_(dvl.subject.lever_arm_m - gnss.subject.lever_arm_m),
      with_imu_(imu != nullptr),
      sensor_(dvl, dvl.quantities[0], gnss.origins.front().valid_at),
      reference_(gnss, over_ground_of(gnss), gnss.origins.front().valid_at),
      attitude_(dvl, unwrapped(dvl.attitude), gnss.origins.front().valid_at),
      rate_(rate_of(imu, gnss.origins.front().valid_at)) {}

std::optional<double> AtOnePlace::heading(double t_s) const {
  const auto& source = has_attitude() ? attitude_ : reference_;
  const auto there = source.at(t_s);
  if (!there) return std::nullopt;
  return has_attitude() ? std::optional(there->z()) : course_of(*there);
}

bool AtOnePlace::is_straight(double t_s) const {
  const auto before = heading(t_s - 1), after = heading(t_s + 1);
  if (!before || !after) return false;
  return std::abs(std::remainder(*after - *before, 2 * std::numbers::pi)) / 2 <
         straight_within_radps;
}

std::optional<VelocityPair> AtOnePlace::pair(std::size_t i, double delay_s) const {
  const double fix_t = reference_.times()[i], t = fix_t + delay_s;
  const auto reading = sensor_.at(t);
  if (!reading) return std::nullopt;
  Vector3d rate = Vector3d::Zero();
  if (with_imu_) {
    const auto turning = rate_.at(t);
    if (!turning) return std::nullopt;
    rate = *turning;
  }
  if (!(with_imu_ && has_attitude()) && !is_straight(t)) return std::nullopt;

  Vector3d over_ground = reference_.values()[i];
  if (has_attitude()) {
    const auto angles = attitude_.at(t);
    if (!angles) return std::nullopt;
    over_ground = frame::ned_to_body({angles->x(), angles->y(), angles->z()}) * over_ground;
  } else {
    if (!course_of(over_ground)) return std::nullopt;
    over_ground = body_to_sensor_ * Vector3d(over_ground.head<2>().norm(), 0, 0);
  }
  const Vector3d there = over_ground + body_to_sensor_ * rate.cross(arm_);
  return VelocityPair{fix_t, reading->head<2>(), there.head<2>()};
}

}  // namespace drydock::characterize
