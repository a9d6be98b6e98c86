#include "hil/motion/splined/splined_trajectory.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/earth.hpp"
#include "hil/motion/bad_mission.hpp"
#include "hil/motion/inertial.hpp"
#include "hil/motion/splined/pose_file.hpp"
#include "hil/motion/vehicle/actuator_law.hpp"

namespace drydock::motion {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

std::vector<double> knots_of(const Poses& poses) {
  std::vector<double> knots;
  for (const auto& pose : poses) knots.push_back(pose.t_s);
  return knots;
}

std::vector<Vector3d> places_of(const Poses& poses) {
  std::vector<Vector3d> places;
  double longitude = 0;  // goes on over the date line
  const auto& origin = poses.front().position;
  for (const auto& pose : poses) {
    longitude += std::remainder(pose.position.longitude_rad - origin.longitude_rad - longitude,
                                2 * std::numbers::pi);
    places.emplace_back(pose.position.latitude_rad - origin.latitude_rad, longitude,
                        pose.position.height_m);
  }
  return places;
}

/// q and -q are one attitude: each has the sign that is nearer to the one before.
std::vector<Vector4d> quaternions_of(const Poses& poses) {
  std::vector<Vector4d> all;
  for (const auto& pose : poses) {
    const auto& q = pose.body_to_ned;
    Vector4d parts{q.w(), q.x(), q.y(), q.z()};
    if (!all.empty() && parts.dot(all.back()) < 0) parts = -parts;
    all.push_back(parts);
  }
  return all;
}

Eigen::Quaterniond quaternion(const Vector4d& parts) {
  return {parts[0], parts[1], parts[2], parts[3]};
}

/// Attitude, rate and angular acceleration. With w = q^-1 q' the rate is twice its vector part, and
/// the length of q, which is not 1 between knots, falls out.
void set_attitude(const CubicSpline<4>::Point& spline, Truth& truth) {
  const auto inverse = quaternion(spline.value).inverse();
  const auto first = inverse * quaternion(spline.rate);
  const auto second = inverse * quaternion(spline.acceleration);
  truth.body_to_ned = quaternion(spline.value).normalized();
  truth.rate_body = 2 * first.vec();
  truth.angular_acceleration = 2 * (second.vec() - 2 * first.w() * first.vec());
  const auto angles = frame::euler(truth.body_to_ned);
  truth.roll_rad = angles.roll;
  truth.pitch_rad = angles.pitch;
  truth.yaw_rad = angles.yaw;
}

struct NedVelocity {
  Vector3d ned, rate;  ///< m/s; of its NED components, m/s2
};

/// From the derivatives of latitude, longitude and height.
NedVelocity velocity_of(double latitude, const CubicSpline<3>::Point& place) {
  const double h = place.value.z();
  const double north = frame::meridian_radius(latitude), east = frame::transverse_radius(latitude);
  const double sine = std::sin(latitude), cosine = std::cos(latitude);
  const double flat = frame::wgs84::eccentricity_squared;
  const double bend = flat * sine * cosine / (1 - flat * sine * sine);
  const double lat1 = place.rate.x(), lon1 = place.rate.y(), h1 = place.rate.z();
  const double lat2 = place.acceleration.x(), lon2 = place.acceleration.y();
  return {{(north + h) * lat1, (east + h) * cosine * lon1, -h1},
          {(north + h) * lat2 + (3 * north * bend * lat1 + h1) * lat1,
           (east + h) * (cosine * lon2 - sine * lat1 * lon1) +
               (east * bend * lat1 + h1) * cosine * lon1,
           -place.acceleration.z()}};
}

Poses poses_of(const rig_config::MissionConfig& mission) {
  try {
    return read_poses(mission.track->file, {mission.latitude_rad, mission.longitude_rad, 0});
  } catch (const BadPoses& error) {
    throw BadMission("/track/file", error.what());
  }
}

}  // namespace

SplinedTrajectory::SplinedTrajectory(const rig_config::MissionConfig& mission, Stamp start)
    : SplinedTrajectory(
          poses_of(mission),
          ocean::Ocean(mission.ocean, {mission.latitude_rad, mission.longitude_rad, 0}), start) {}

SplinedTrajectory::SplinedTrajectory(const Poses& poses, ocean::Ocean ocean, Stamp start)
    : start_(start),
      ocean_(std::move(ocean)),
      origin_(poses.front().position),
      end_s_(poses.back().t_s),
      place_(knots_of(poses), places_of(poses)),
      attitude_(knots_of(poses), quaternions_of(poses)) {
  check_clear_of_bed(poses);
}

void SplinedTrajectory::check_clear_of_bed(const Poses& poses) const {
  for (const auto& pose : poses) {
    const auto& at = pose.position;
    const double bed_m = ocean_.bed_depth_m(at.latitude_rad, at.longitude_rad);
    if (-at.height_m >= bed_m)
      throw BadMission("/track/file",
                       fmt::format("after {:.1f} s the vehicle would be {:.1f} m deep, at or below "
                                   "the sea bed ({:.1f} m there)",
                                   pose.t_s, -at.height_m, bed_m));
  }
}

SplinedTrajectory::Motion SplinedTrajectory::motion_at(double t) const {
  const double inside = std::clamp(t, 0.0, end_s_);
  Motion motion{place_.at(inside), attitude_.at(inside)};
  if (t == inside) return motion;
  if (t < 0)
    motion.place.value += t * motion.place.rate;
  else
    motion.place.rate.setZero();
  motion.place.acceleration.setZero();
  motion.attitude.rate.setZero();
  motion.attitude.acceleration.setZero();
  return motion;
}

Truth SplinedTrajectory::at(Stamp time) const {
  const double t = measurement::seconds(time - start_);
  const Motion motion = motion_at(t);
  Truth truth;
  truth.at = time;
  truth.latitude_rad = origin_.latitude_rad + motion.place.value.x();
  truth.longitude_rad = frame::wrap_pi(origin_.longitude_rad + motion.place.value.y());
  truth.height_m = motion.place.value.z();
  set_attitude(motion.attitude, truth);
  const auto velocity = velocity_of(truth.latitude_rad, motion.place);
  truth.velocity_ned = velocity.ned;
  truth.velocity_body = truth.body_to_ned.conjugate() * velocity.ned;
  set_inertial(velocity.rate, truth);
  truth.current_ned = ocean_.current_ned(-truth.height_m, t);
  truth.bed_depth_m = ocean_.bed_depth_m(truth.latitude_rad, truth.longitude_rad);
  set_actuators(truth);
  return truth;
}

}  // namespace drydock::motion
