#include "hil/motion/vehicle/vehicle_trajectory.hpp"

#include <algorithm>

#include "estimators/frame/attitude.hpp"
#include "hil/motion/inertial.hpp"

namespace drydock::motion {

VehicleTrajectory::VehicleTrajectory(const rig_config::MissionConfig& mission, Stamp start)
    : voyage_(mission), start_(start) {}

Stamp VehicleTrajectory::end() const { return start_ + measurement::from_seconds(voyage_.lap_s()); }

Truth VehicleTrajectory::at(Stamp time) const {
  const std::int64_t ns = std::max<std::int64_t>((time - start_).count(), 0);
  const VoyageStep step = voyage_.at(ns / voyage_step_ns);
  const double within = static_cast<double>(ns % voyage_step_ns) * 1e-9;
  const double t = static_cast<double>(ns) * 1e-9;
  VehicleState s = step.state;
  VehicleRate rate = step.rate;
  Actuators actuators = step.actuators;
  if (within > 0) {
    const double begin = static_cast<double>(ns - ns % voyage_step_ns) * 1e-9;
    s = voyage_.motion().step(s, step.rate, actuators, step.command, begin, within);
    rate = voyage_.motion().rate(s, actuators.control(), t);
  }
  const auto control = actuators.control();

  Truth truth;
  truth.at = time;
  truth.latitude_rad = s.latitude_rad;
  truth.longitude_rad = frame::wrap_pi(s.longitude_rad);
  truth.height_m = s.height_m;
  truth.body_to_ned = s.body_to_ned;
  if (truth.body_to_ned.w() < 0) truth.body_to_ned.coeffs() = -truth.body_to_ned.coeffs();
  const frame::Euler attitude = frame::euler(s.body_to_ned);
  truth.roll_rad = attitude.roll;
  truth.pitch_rad = attitude.pitch;
  truth.yaw_rad = attitude.yaw;
  truth.velocity_ned = rate.velocity_ned;
  truth.velocity_body = truth.body_to_ned.conjugate() * rate.velocity_ned;
  truth.rate_body = s.velocity.tail<3>();
  set_inertial(voyage_.motion().acceleration_ned(s, rate, t), truth);
  // Leaves out the derivative of the transport rate, which is below 1e-7 rad/s2 at 0.6 m/s2.
  truth.angular_acceleration = rate.velocity.tail<3>() - truth.rate_body.cross(truth.angular_rate);
  truth.current_ned = ocean().current_ned(-s.height_m, t);
  truth.bed_depth_m = ocean().bed_depth_m(truth.latitude_rad, truth.longitude_rad);
  truth.rudder_rad = control.delta_r;
  truth.stern_plane_rad = control.delta_s;
  truth.bow_plane_rad = control.delta_b;
  truth.propeller_radps = actuators.propeller_radps();
  return truth;
}

}  // namespace drydock::motion
