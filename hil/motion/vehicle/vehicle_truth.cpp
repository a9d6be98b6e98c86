#include "hil/motion/vehicle/vehicle_truth.hpp"

#include "estimators/frame/attitude.hpp"
#include "hil/motion/inertial.hpp"

namespace drydock::motion {

Truth truth_of(const VehicleState& s, const VehicleRate& rate,
               const Eigen::Vector3d& acceleration_ned, const ocean::Ocean& ocean, double t_s) {
  Truth truth;
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
  set_inertial(acceleration_ned, truth);
  // Leaves out the derivative of the transport rate, which is below 1e-7 rad/s2 at 0.6 m/s2.
  truth.angular_acceleration = rate.velocity.tail<3>() - truth.rate_body.cross(truth.angular_rate);
  truth.current_ned = ocean.current_ned(-s.height_m, t_s);
  truth.bed_depth_m = ocean.bed_depth_m(truth.latitude_rad, truth.longitude_rad);
  return truth;
}

}  // namespace drydock::motion
