#include "hil/motion/kinematic_trajectory.hpp"

#include <fmt/format.h>

#include <cmath>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/earth.hpp"
#include "hil/motion/bad_mission.hpp"
#include "hil/motion/inertial.hpp"
#include "hil/motion/vehicle/actuator_law.hpp"

namespace drydock::motion {
namespace {

// Keeps position and velocity consistent to 2e-6 m/s even in the shortest usual ramps.
constexpr double spacing_s = 0.5;
// For a lag of at least half a second: error 1e-9 of its input. A shorter lag needs shorter steps.
constexpr double spacing_in_lags = 0.1;

}  // namespace

KinematicTrajectory::KinematicTrajectory(const rig_config::MissionConfig& mission, Stamp start)
    : start_(start),
      ocean_(mission.ocean, {mission.latitude_rad, mission.longitude_rad, 0}),
      profile_(mission),
      pivot_m_(mission.pivot_m),
      sideslip_lag_s_(mission.sideslip_lag_s),
      spacing_s_(pivot_m_ > 0 ? spacing_in_lags * sideslip_lag_s_ : spacing_s),
      checkpoints_(checkpoint_of(0, Path{mission.latitude_rad, mission.longitude_rad})) {
  check_clear_of_bed();
}

void KinematicTrajectory::check_clear_of_bed() const {
  const auto looks = static_cast<int>(profile_.lap_s() / spacing_s);
  for (int look = 0; look <= looks; ++look) {
    const double t = look * spacing_s;
    const Prescribed p = profile_.at(t);
    const Path place = path_at(t, p);
    const double bed_m = ocean_.bed_depth_m(place.latitude_rad, place.longitude_rad);
    const double depth_m = p.depth_m + place.slip_depth_m;
    if (depth_m >= bed_m)
      throw BadMission(
          profile_.path_at(t),
          fmt::format("mission: after {:.0f} s the vehicle would be {:.1f} m deep, at or below the "
                      "sea bed ({:.1f} m there)",
                      t, depth_m, bed_m));
  }
}

Stamp KinematicTrajectory::end() const {
  return start_ + measurement::from_seconds(profile_.lap_s());
}

Truth KinematicTrajectory::at(Stamp time) const {
  const double t = measurement::seconds(time - start_);
  const Prescribed p = profile_.at(t);
  const Path path = path_at(t, p);

  Truth truth;
  truth.at = time;
  truth.latitude_rad = path.latitude_rad;
  truth.longitude_rad = frame::wrap_pi(path.longitude_rad);
  truth.height_m = -p.depth_m - path.slip_depth_m;
  truth.roll_rad = p.roll.value;
  truth.pitch_rad = p.pitch.value;
  truth.yaw_rad = frame::wrap_pi(p.yaw.value);

  const frame::Euler attitude{truth.roll_rad, truth.pitch_rad, truth.yaw_rad};
  truth.body_to_ned = frame::body_to_ned(attitude);
  truth.rate_body = frame::body_rate(attitude, {p.roll.rate, p.pitch.rate, p.yaw.rate});
  truth.velocity_body << p.speed.value, path.slip_mps;
  truth.velocity_ned = truth.body_to_ned * truth.velocity_body;
  Eigen::Vector3d change;
  change << p.speed.rate, (path.lagged - path.slip_mps) / sideslip_lag_s_;
  const Eigen::Vector3d acceleration_body = change + truth.rate_body.cross(truth.velocity_body);
  set_inertial(truth.body_to_ned * acceleration_body, truth);

  truth.current_ned = ocean_.current_ned(-truth.height_m, t);
  truth.bed_depth_m = ocean_.bed_depth_m(truth.latitude_rad, truth.longitude_rad);
  set_actuators(truth);
  return truth;
}

KinematicTrajectory::Path KinematicTrajectory::path_at(double t, const Prescribed& p) const {
  const auto index = static_cast<std::size_t>(std::max(t, 0.0) / spacing_s_);
  Checkpoint checkpoint;
  {
    const std::lock_guard lock(mutex_);
    checkpoint = checkpoints_.at(index, [&](const Checkpoint& from, std::size_t step) {
      const double begin = spacing_s_ * static_cast<double>(step);
      const Course at_end(profile_.at(begin + spacing_s_));
      return checkpoint_of(step + 1, integrate(from, begin, spacing_s_, at_end));
    });
  }
  const double from = spacing_s_ * static_cast<double>(index);
  // The end, from + (t - from), is `t` to the last bit: numbers within a factor of 2 of each other
  // have an exact difference (Sterbenz).
  return integrate(checkpoint, from, t - from, Course(p));
}

KinematicTrajectory::Checkpoint KinematicTrajectory::checkpoint_of(std::size_t index,
                                                                   const Path& path) const {
  return {path, derivative(Course(profile_.at(spacing_s_ * static_cast<double>(index))), path)};
}

KinematicTrajectory::Course::Course(const Prescribed& prescribed)
    : p(prescribed),
      sin_pitch(std::sin(p.pitch.value)),
      cos_pitch(std::cos(p.pitch.value)),
      sin_yaw(std::sin(p.yaw.value)),
      cos_yaw(std::cos(p.yaw.value)) {}

KinematicTrajectory::Path KinematicTrajectory::derivative(const Course& course,
                                                          const Path& path) const {
  const auto& [p, sin_pitch, cos_pitch, sin_yaw, cos_yaw] = course;
  double ahead = p.speed.value * cos_pitch, abeam = 0;  // over ground, relative to the heading
  Path rate;
  if (pivot_m_ > 0) {
    const double sin_roll = std::sin(p.roll.value), cos_roll = std::cos(p.roll.value);
    const double v = path.slip_mps.x(), w = path.slip_mps.y();
    const double under_deck = v * sin_roll + w * cos_roll;
    ahead += under_deck * sin_pitch;
    abeam = v * cos_roll - w * sin_roll;
    rate.slip_depth_m = under_deck * cos_pitch;
    const Eigen::Vector3d turning = frame::body_rate({p.roll.value, p.pitch.value, p.yaw.value},
                                                     {p.roll.rate, p.pitch.rate, p.yaw.rate});
    const Eigen::Vector2d steady = pivot_m_ * Eigen::Vector2d{-turning.z(), turning.y()};
    rate.lagged = (steady - path.lagged) / sideslip_lag_s_;
    rate.slip_mps = (path.lagged - path.slip_mps) / sideslip_lag_s_;
  }
  const double depth = p.depth_m + path.slip_depth_m;
  rate.latitude_rad =
      (ahead * cos_yaw - abeam * sin_yaw) / (frame::meridian_radius(path.latitude_rad) - depth);
  rate.longitude_rad =
      (ahead * sin_yaw + abeam * cos_yaw) /
      ((frame::transverse_radius(path.latitude_rad) - depth) * std::cos(path.latitude_rad));
  return rate;
}

// One step of Runge-Kutta 4.
KinematicTrajectory::Path KinematicTrajectory::integrate(const Checkpoint& from, double t,
                                                         double duration,
                                                         const Course& at_end) const {
  const auto moved = [](const Path& path, double h, const Path& rate) -> Path {
    return {path.latitude_rad + h * rate.latitude_rad, path.longitude_rad + h * rate.longitude_rad,
            path.slip_depth_m + h * rate.slip_depth_m, path.lagged + h * rate.lagged,
            path.slip_mps + h * rate.slip_mps};
  };
  const auto& [begin, k1] = from;
  const Course middle(profile_.at(t + duration / 2));
  const Path k2 = derivative(middle, moved(begin, duration / 2, k1));
  const Path k3 = derivative(middle, moved(begin, duration / 2, k2));
  const Path k4 = derivative(at_end, moved(begin, duration, k3));
  const Path halfway = moved(moved(begin, duration / 6, k1), duration / 3, k2);
  return moved(moved(halfway, duration / 3, k3), duration / 6, k4);
}

}  // namespace drydock::motion
