#pragma once

#include <Eigen/QR>
#include <vector>

#include "drivers/measurement/joint_order.hpp"
#include "hil/motion/steered/thruster.hpp"

namespace drydock::steer {

/// Shares a force and moment on the body among thrusters by the generalized inverse of their
/// configuration matrix, which asks for the least sum of squared pushes (Fossen, Handbook of Marine
/// Craft Hydrodynamics and Motion Control, 2011, section 12.3). What the thrusters cannot give is
/// left out in the sense of least squares.
class ThrustAllocation {
 public:
  /// At least one thruster.
  explicit ThrustAllocation(std::vector<motion::Thruster> thrusters);

  /// The push of each thruster, N. If one is beyond its limit all are made smaller by the same
  /// factor, so that the direction stays.
  std::vector<double> pushes(const measurement::BodyWrench& wrench) const;

 private:
  std::vector<motion::Thruster> thrusters_;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> configuration_;
};

}  // namespace drydock::steer
