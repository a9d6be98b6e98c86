#pragma once

#include <Eigen/Core>

#include "hil/motion/truth.hpp"
#include "hil/sensor/mounting.hpp"

namespace drydock::sensor {

/// The output of an integrating inertial measurement unit over an interval, in its own axes: the
/// integrals of angular rate against inertial space and of specific force, for each component
/// separately. The mechanization that uses them corrects for coning and sculling.
struct Increments {
  Eigen::Vector3d angle = Eigen::Vector3d::Zero();     ///< rad
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< m/s
};

/// Integrates a trajectory, one interval after another, by Simpson's rule in pieces of at most 10
/// ms. In the force at the lever arm r, dw/dt x r integrates to the exact change of w x r.
/// docs/world/vehicle.md, eq. (10), (11). The steps should begin at the start of the trajectory:
/// then no piece contains a kink of a command.
class IncrementIntegrator {
 public:
  IncrementIntegrator(const motion::Trajectory& trajectory, motion::Stamp from,
                      const Mounting& mounting = {});

  /// From the end of the previous interval to `to`, which must not be earlier.
  Increments until(motion::Stamp to);

 private:
  const motion::Trajectory& trajectory_;
  Mounting mounting_;
  motion::Truth last_;
};

}  // namespace drydock::sensor
