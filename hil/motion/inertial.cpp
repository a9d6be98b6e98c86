#include "hil/motion/inertial.hpp"

#include "estimators/frame/earth.hpp"

namespace drydock::motion {

void set_inertial(const Eigen::Vector3d& acceleration_ned, Truth& truth) {
  const Eigen::Vector3d earth_rate = frame::earth_rate_ned(truth.latitude_rad);
  const Eigen::Vector3d transport_rate =
      frame::transport_rate_ned(truth.latitude_rad, truth.height_m, truth.velocity_ned);
  const Eigen::Vector3d gravity{0, 0, frame::gravity(truth.latitude_rad, truth.height_m)};
  const Eigen::Quaterniond ned_to_body = truth.body_to_ned.conjugate();
  truth.specific_force =
      ned_to_body *
      (acceleration_ned + (2 * earth_rate + transport_rate).cross(truth.velocity_ned) - gravity);
  truth.angular_rate = truth.rate_body + ned_to_body * (earth_rate + transport_rate);
}

}  // namespace drydock::motion
