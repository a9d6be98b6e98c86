#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "estimators/frame/geodetic.hpp"
#include "estimators/navigation/increments.hpp"

/// Strapdown inertial navigation on WGS-84, eq. (13) of docs/estimators/navigation.md.
namespace drydock::navigation {

struct NavigationState {
  frame::Position position;
  Eigen::Vector3d velocity_ned = Eigen::Vector3d::Zero();  ///< m/s over ground
  Eigen::Quaterniond body_to_ned = Eigen::Quaterniond::Identity();
};

/// Gains of the third-order loop that corrects the height to a reference, eq. (N5).
struct HeightLoop {
  double k1 = 0, k2 = 0, k3 = 0;  ///< 1/s, 1/s2, 1/s3; all 0: free inertial height, which diverges

  /// Three poles at -1/tau.
  static HeightLoop of_time_constant(double tau_s) {
    return {3 / tau_s, 3 / (tau_s * tau_s), 1 / (tau_s * tau_s * tau_s)};
  }
};

/// Allocates nothing, throws nothing. Not usable at the poles.
class Sdins {
 public:
  explicit Sdins(const NavigationState& start, const HeightLoop& loop = {})
      : state_(start), loop_(loop) {}

  /// One step of eq. (13). `reference_height_m` (above the ellipsoid, up) drives the height loop;
  /// without it the loop keeps its last correction.
  void step(const Increments& increments, std::optional<double> reference_height_m = {});

  /// Removes estimated errors from the state. An error is IN minus truth: position [rad rad m],
  /// velocity m/s, attitude phi with C_IN = (I - phi x) C.
  void correct(const Eigen::Vector3d& position, const Eigen::Vector3d& velocity,
               const Eigen::Vector3d& phi);

  const NavigationState& state() const { return state_; }
  const HeightLoop& loop() const { return loop_; }

  /// Mean specific force over the last step, in NED, m/s2.
  const Eigen::Vector3d& force_ned() const { return force_ned_; }

 private:
  NavigationState state_;
  HeightLoop loop_;
  Eigen::Vector3d acceleration_ = Eigen::Vector3d::Zero();  ///< dV/dt of the last step
  Eigen::Vector3d force_ned_ = Eigen::Vector3d::Zero();
  double loop_acceleration_ = 0;  ///< a of eq. (N5), m/s2 down
};

/// The unit quaternion of a rotation vector. The error is below 1e-15.
Eigen::Quaterniond quaternion_of(const Eigen::Vector3d& rotation);

}  // namespace drydock::navigation
