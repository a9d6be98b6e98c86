#include "hil/motion/kinematic_trajectory.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/earth.hpp"
#include "hil/motion/actuator_law.hpp"
#include "hil/motion/inertial.hpp"

namespace drydock::motion {
namespace {

// Keeps position and velocity consistent to 2e-6 m/s through the shortest usual ramps.
constexpr double spacing_s = 0.5;

}  // namespace

KinematicTrajectory::KinematicTrajectory(const rig_config::MissionConfig& mission, Stamp start)
    : start_(start),
      ocean_(mission.ocean, {mission.latitude_rad, mission.longitude_rad, 0}),
      profile_(mission),
      checkpoints_{{mission.latitude_rad, mission.longitude_rad}} {
  check_clear_of_bed();
}

void KinematicTrajectory::check_clear_of_bed() const {
  const double lap_s = profile_.lap_s();
  for (double t = 0; t <= lap_s; t += spacing_s) {
    const Position place = position_at(t);
    const double bed_m = ocean_.bed_depth_m(place.latitude_rad, place.longitude_rad);
    if (profile_.at(t).depth_m >= bed_m)
      throw std::invalid_argument(
          fmt::format("mission: after {:.0f} s the vehicle would be {:.1f} m deep, at or below the "
                      "sea bed ({:.1f} m there)",
                      t, profile_.at(t).depth_m, bed_m));
  }
}

Stamp KinematicTrajectory::end() const {
  return start_ + measurement::from_seconds(profile_.lap_s());
}

Truth KinematicTrajectory::at(Stamp time) const {
  const double t = measurement::seconds(time - start_);
  const Prescribed p = profile_.at(t);
  const Position position = position_at(t);

  Truth truth;
  truth.at = time;
  truth.latitude_rad = position.latitude_rad;
  truth.longitude_rad = frame::wrap_pi(position.longitude_rad);
  truth.height_m = -p.depth_m;
  truth.roll_rad = p.roll.value;
  truth.pitch_rad = p.pitch.value;
  truth.yaw_rad = frame::wrap_pi(p.yaw.value);

  const frame::Euler attitude{truth.roll_rad, truth.pitch_rad, truth.yaw_rad};
  truth.body_to_ned = frame::body_to_ned(attitude);
  truth.rate_body = frame::body_rate(attitude, {p.roll.rate, p.pitch.rate, p.yaw.rate});
  truth.velocity_body = {p.speed.value, 0, 0};
  truth.velocity_ned = truth.body_to_ned * truth.velocity_body;
  const Eigen::Vector3d acceleration_body =
      Eigen::Vector3d{p.speed.rate, 0, 0} + truth.rate_body.cross(truth.velocity_body);
  set_inertial(truth.body_to_ned * acceleration_body, truth);

  truth.current_ned = ocean_.current_ned(p.depth_m, t);
  truth.bed_depth_m = ocean_.bed_depth_m(truth.latitude_rad, truth.longitude_rad);
  set_actuators(truth);
  return truth;
}

KinematicTrajectory::Position KinematicTrajectory::position_at(double t) const {
  const auto index = static_cast<std::size_t>(std::max(t, 0.0) / spacing_s);
  Position checkpoint;
  {
    const std::lock_guard lock(mutex_);
    while (checkpoints_.size() <= index) {
      const double from = spacing_s * static_cast<double>(checkpoints_.size() - 1);
      checkpoints_.push_back(integrate(checkpoints_.back(), from, spacing_s));
    }
    checkpoint = checkpoints_[index];
  }
  const double from = spacing_s * static_cast<double>(index);
  return integrate(checkpoint, from, t - from);
}

// One step of Runge-Kutta 4 (Simpson's rule, since latitude hardly changes within a step).
KinematicTrajectory::Position KinematicTrajectory::integrate(Position from, double t,
                                                             double duration) const {
  const auto rate = [](const Prescribed& p, double latitude) -> Position {
    const double level = p.speed.value * std::cos(p.pitch.value);
    const double east_radius = frame::transverse_radius(latitude) - p.depth_m;
    return {level * std::cos(p.yaw.value) / (frame::meridian_radius(latitude) - p.depth_m),
            level * std::sin(p.yaw.value) / (east_radius * std::cos(latitude))};
  };
  const Prescribed middle = profile_.at(t + duration / 2);
  const double lat = from.latitude_rad;
  const Position k1 = rate(profile_.at(t), lat);
  const Position k2 = rate(middle, lat + duration / 2 * k1.latitude_rad);
  const Position k3 = rate(middle, lat + duration / 2 * k2.latitude_rad);
  const Position k4 = rate(profile_.at(t + duration), lat + duration * k3.latitude_rad);
  const auto advance = [duration](double a, double b, double c, double d) {
    return duration / 6 * (a + 2 * b + 2 * c + d);
  };
  return {lat + advance(k1.latitude_rad, k2.latitude_rad, k3.latitude_rad, k4.latitude_rad),
          from.longitude_rad +
              advance(k1.longitude_rad, k2.longitude_rad, k3.longitude_rad, k4.longitude_rad)};
}

}  // namespace drydock::motion
