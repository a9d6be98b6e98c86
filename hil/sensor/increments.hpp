#pragma once

#include <Eigen/Core>

#include "hil/motion/truth.hpp"
#include "hil/sensor/mounting.hpp"

namespace drydock::sensor {

/// What an integrating inertial measurement unit gives over an interval, in its own axes: the
/// integrals of angular rate against inertial space and of specific force, each component for
/// itself. Coning and sculling are in the mechanization that uses them.
struct Increments {
  Eigen::Vector3d angle = Eigen::Vector3d::Zero();     ///< rad
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s
};

/// Integrates a trajectory from a time on, interval after interval, by Simpson's rule in pieces of
/// 10 ms or less. Of the force at the lever arm r, dw/dt x r integrates to the exact change of
/// w x r. docs/world/vehicle.md, eq. (10), (11). The trajectory and the start of its steps are best
/// the same: then no kink of a command lies within a piece.
class IncrementIntegrator {
 public:
  IncrementIntegrator(const motion::Trajectory& trajectory, motion::Stamp from,
                      const Mounting& mounting = {});

  /// From the end of the interval before to `to`, which is not earlier.
  Increments until(motion::Stamp to);

 private:
  const motion::Trajectory& trajectory_;
  Mounting mounting_;
  motion::Truth last_;
};

}  // namespace drydock::sensor
