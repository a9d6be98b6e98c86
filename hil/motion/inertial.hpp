#pragma once

#include <Eigen/Core>

#include "hil/motion/truth.hpp"

namespace drydock::motion {

/// Sets the specific force and the angular rate of an inertial measurement unit at the vehicle's
/// origin on the rotating WGS-84 Earth. It uses the place, attitude, rates and velocity that the
/// truth already has, and dV^n/dt, m/s2:
///   f^b    = C_n^b [ dV^n/dt + (2 w_ie + w_en) x V^n - g^n ]
///   w_ib^b = w_nb^b + C_n^b (w_ie^n + w_en^n)
void set_inertial(const Eigen::Vector3d& acceleration_ned, Truth& truth);

}  // namespace drydock::motion
