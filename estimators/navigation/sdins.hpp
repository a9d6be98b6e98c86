#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "estimators/frame/basic_position.hpp"
#include "estimators/navigation/increments.hpp"

/// Strapdown inertial navigation on WGS-84, eq. (13) of docs/estimators/navigation.md.
namespace drydock::navigation {

template <class Real>
struct BasicNavigationState {
  frame::BasicPosition<Real> position;
  Eigen::Vector3<Real> velocity_ned = Eigen::Vector3<Real>::Zero();  ///< m/s over ground
  Eigen::Quaternion<Real> body_to_ned = Eigen::Quaternion<Real>::Identity();
};
using NavigationState = BasicNavigationState<double>;

/// Gains of the third-order loop that corrects the height to a reference, eq. (N5).
struct HeightLoop {
  double k1 = 0, k2 = 0, k3 = 0;  ///< 1/s, 1/s2, 1/s3; all 0: free inertial height, which diverges

  /// Three poles at -1/tau.
  static HeightLoop of_time_constant(double tau_s) {
    return {3 / tau_s, 3 / (tau_s * tau_s), 1 / (tau_s * tau_s * tau_s)};
  }
};

/// Allocates nothing, throws nothing. Not usable at the poles.
template <class Real>
class BasicSdins {
 public:
  using Vector = Eigen::Vector3<Real>;
  using State = BasicNavigationState<Real>;

  explicit BasicSdins(const State& start, const HeightLoop& loop = {})
      : state_(start), loop_(loop) {}

  /// One step of eq. (13). `reference_height_m` (above the ellipsoid, up) drives the height loop;
  /// without it the loop keeps its last correction.
  void step(const BasicIncrements<Real>& increments, std::optional<Real> reference_height_m = {});

  /// Removes estimated errors from the state. An error is IN minus truth: position [rad rad m],
  /// velocity m/s, attitude phi with C_IN = (I - phi x) C.
  void correct(const Vector& position, const Vector& velocity, const Vector& phi);

  const State& state() const { return state_; }
  const HeightLoop& loop() const { return loop_; }

  /// Mean specific force over the last step, in NED, m/s2.
  const Vector& force_ned() const { return force_ned_; }

 private:
  State state_;
  HeightLoop loop_;
  Vector acceleration_ = Vector::Zero();  ///< dV/dt of the last step
  Vector force_ned_ = Vector::Zero();
  Real loop_acceleration_ = 0;  ///< a of eq. (N5), m/s2 down
};
using Sdins = BasicSdins<double>;

/// The unit quaternion of a rotation vector. The error is below 1e-15.
Eigen::Quaterniond quaternion_of(const Eigen::Vector3d& rotation);
/// The same for any rotation, with sine and cosine.
Eigen::Quaterniond far_turn(const Eigen::Vector3d& rotation);
template <class Real>
Eigen::Quaternion<Real> quaternion_of(const Eigen::Vector3<Real>& rotation);

}  // namespace drydock::navigation
