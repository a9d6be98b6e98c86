#include "hil/motion/ballistic_trajectory.hpp"

#include <algorithm>
#include <cmath>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/earth.hpp"
#include "hil/motion/bad_mission.hpp"
#include "hil/motion/inertial.hpp"
#include "hil/motion/smooth_step.hpp"

namespace drydock::motion {
namespace {

using Eigen::Vector3d;

constexpr double flight_step_s = 0.05;  // Runge-Kutta 4: error below a micrometre over the whole
                                        // flight
constexpr double longest_flight_s = 3600;
constexpr double series_end_m = 500e3;  // the series of normal gravity is wrong by 0.2 % there

// Isothermal air with the sea-level density and scale height of the US Standard Atmosphere 1976.
constexpr double sea_level_density_kgm3 = 1.225, scale_height_m = 8434.5;

}  // namespace

BallisticTrajectory::BallisticTrajectory(const rig_config::MissionConfig& mission, Stamp start)
    : flight_(mission.ballistic.value()),
      ocean_(mission.ocean, {mission.latitude_rad, mission.longitude_rad, 0}),
      start_(start) {
  if (flight_.height_m < flight_.ground_height_m)
    throw BadMission("/ballistic/height_m",
                     "mission: the ballistic flight begins below the ground");
  const double across = mission.speed_mps * std::cos(flight_.elevation_rad);
  State s{mission.latitude_rad,
          mission.longitude_rad,
          flight_.height_m,
          {across * std::cos(mission.heading_rad), across * std::sin(mission.heading_rad),
           -mission.speed_mps * std::sin(flight_.elevation_rad)}};
  checkpoints_.push_back(s);
  while (s.height_m >= flight_.ground_height_m) {
    if (s.height_m > series_end_m)
      throw BadMission("/ballistic", "mission: the ballistic flight climbs above 500 km");
    if (flight_step_s * static_cast<double>(checkpoints_.size()) > longest_flight_s)
      throw BadMission("/ballistic", "mission: the ballistic flight does not end within an hour");
    checkpoints_.push_back(s = step(s, flight_step_s));
  }
  const auto steps_above = static_cast<double>(checkpoints_.size() - 2);
  const double landing_s = flight_step_s * steps_above + landing_within_last_step();
  landing_s_ = measurement::seconds(measurement::from_seconds(landing_s));  // at(end()) is still in
                                                                            // flight
}

Stamp BallisticTrajectory::end() const { return start_ + measurement::from_seconds(landing_s_); }

/// Bisection to a nanosecond between the last point above the ground and the first one below.
double BallisticTrajectory::landing_within_last_step() const {
  const State& above = checkpoints_[checkpoints_.size() - 2];
  double low = 0, high = flight_step_s;
  while (high - low > 1e-9) {
    const double middle = (low + high) / 2;
    (step(above, middle).height_m >= flight_.ground_height_m ? low : high) = middle;
  }
  return low;
}

Truth BallisticTrajectory::at(Stamp time) const {
  const double t = std::max(measurement::seconds(time - start_), 0.0);
  const bool landed = t > landing_s_;
  const double in_flight = std::min(t, landing_s_);
  const State s = state_at(in_flight);
  const Vector3d acceleration = derivative(s).velocity_ned;
  const Attitude attitude = attitude_at(in_flight, s.velocity_ned, acceleration);

  Truth truth;
  truth.at = time;
  truth.latitude_rad = s.latitude_rad;
  truth.longitude_rad = frame::wrap_pi(s.longitude_rad);
  truth.height_m = s.height_m;
  const frame::Euler angles{frame::wrap_pi(attitude.angles.x()), attitude.angles.y(),
                            frame::wrap_pi(attitude.angles.z())};
  truth.roll_rad = angles.roll;
  truth.pitch_rad = angles.pitch;
  truth.yaw_rad = angles.yaw;
  truth.body_to_ned = frame::body_to_ned(angles);
  if (!landed) {
    truth.velocity_ned = s.velocity_ned;
    truth.velocity_body = truth.body_to_ned.conjugate() * s.velocity_ned;
    truth.rate_body = frame::body_rate(angles, attitude.rates);
  }
  set_inertial(landed ? Vector3d::Zero().eval() : acceleration, truth);

  truth.current_ned = ocean_.current_ned(-s.height_m, t);
  truth.bed_depth_m = ocean_.bed_depth_m(s.latitude_rad, s.longitude_rad);
  return truth;
}

BallisticTrajectory::State BallisticTrajectory::state_at(double t) const {
  const auto index = std::min(static_cast<std::size_t>(t / flight_step_s), checkpoints_.size() - 1);
  return step(checkpoints_[index], t - flight_step_s * static_cast<double>(index));
}

BallisticTrajectory::State BallisticTrajectory::step(const State& s, double h) const {
  const auto plus = [](const State& from, double by, const State& d) -> State {
    return {from.latitude_rad + by * d.latitude_rad, from.longitude_rad + by * d.longitude_rad,
            from.height_m + by * d.height_m, from.velocity_ned + by * d.velocity_ned};
  };
  const State k1 = derivative(s), k2 = derivative(plus(s, h / 2, k1));
  const State k3 = derivative(plus(s, h / 2, k2)), k4 = derivative(plus(s, h, k3));
  return plus(plus(plus(plus(s, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
}

// dV^n/dt = g^n + f^n - (2 w_ie + w_en) x V^n on the ellipsoid of WGS-84.
BallisticTrajectory::State BallisticTrajectory::derivative(const State& s) const {
  const Vector3d& v = s.velocity_ned;
  const double north = frame::meridian_radius(s.latitude_rad) + s.height_m;
  const double east = frame::transverse_radius(s.latitude_rad) + s.height_m;
  const Vector3d turning = 2 * frame::earth_rate_ned(s.latitude_rad) +
                           frame::transport_rate_ned(s.latitude_rad, s.height_m, v);
  const Vector3d gravity{0, 0, frame::gravity(s.latitude_rad, s.height_m)};
  return {v.x() / north, v.y() / (east * std::cos(s.latitude_rad)), -v.z(),
          gravity + drag_ned(s) - turning.cross(v)};
}

/// Opposite to the velocity through air that rotates with the Earth, m/s2.
Vector3d BallisticTrajectory::drag_ned(const State& s) const {
  if (flight_.ballistic_coefficient_kgm2 == 0) return Vector3d::Zero();
  const double density = sea_level_density_kgm3 * std::exp(-s.height_m / scale_height_m);
  return -density / (2 * flight_.ballistic_coefficient_kgm2) * s.velocity_ned.norm() *
         s.velocity_ned;
}

BallisticTrajectory::Attitude BallisticTrajectory::attitude_at(double t, const Vector3d& v,
                                                               const Vector3d& a) const {
  const double across = v.head<2>().norm();
  const double across_rate = v.head<2>().dot(a.head<2>()) / across;
  const double path = std::atan2(-v.z(), across);
  const double path_rate = (v.z() * across_rate - a.z() * across) / v.squaredNorm();
  const double course = std::atan2(v.y(), v.x());
  const double course_rate = (v.x() * a.y() - v.y() * a.x()) / (across * across);

  const double cone = flight_.angle_of_attack_rad, w = flight_.coning_radps;
  const double spun = flight_.spin_up_s > 0 ? std::min(t / flight_.spin_up_s, 1.0) : 1;
  const double turned =
      flight_.spin_up_s * quintic_integral(spun) + std::max(t - flight_.spin_up_s, 0.0);
  const double rate = flight_.roll_rate_radps;
  return {{flight_.roll_rad + rate * turned, path + cone * std::sin(w * t),
           course + cone * std::cos(w * t)},
          {rate * quintic(spun), path_rate + cone * w * std::cos(w * t),
           course_rate - cone * w * std::sin(w * t)}};
}

}  // namespace drydock::motion
