#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

/// Attitude conventions of the whole project; docs/world/frames.md explains them. The navigation
/// frame n is NED, the body frame b is FRD. Euler angles turn n into b in the order yaw, pitch,
/// roll (3-2-1).
namespace drydock::frame {

/// Radians. Canonical ranges: roll and yaw (-pi, pi], pitch [-pi/2, pi/2].
struct Euler {
  double roll = 0, pitch = 0, yaw = 0;
};

/// C_n^b: converts the coordinates of a vector from NED to body.
Eigen::Matrix3d ned_to_body(const Euler& attitude);

/// Hamilton unit quaternion, body to NED: `q * v_body` is the vector in NED. Scalar part >= 0.
Eigen::Quaterniond body_to_ned(const Euler& attitude);

/// Canonical angles. At pitch +-pi/2 only yaw -+ roll is defined; the result then has roll 0.
Euler euler(const Eigen::Quaterniond& body_to_ned);
Euler euler(const Eigen::Matrix3d& ned_to_body);

/// Rates of roll, pitch, yaw from [p q r], the rate of the body against NED. Not defined at pitch
/// +-pi/2.
Eigen::Vector3d euler_rates(const Euler& attitude, const Eigen::Vector3d& rate_nb_body);

/// The inverse: [p q r] from the rates of roll, pitch, yaw. Defined everywhere.
Eigen::Vector3d body_rate(const Euler& attitude, const Eigen::Vector3d& rates);

/// skew(a) * b == a x b
Eigen::Matrix3d skew(const Eigen::Vector3d& a);

/// The same angle in (-pi, pi].
double wrap_pi(double angle);

}  // namespace drydock::frame
