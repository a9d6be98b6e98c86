#pragma once

#include <Eigen/Core>

/// What an inertial measurement unit gives, summed over a navigation step with the corrections for
/// coning and sculling. Equation numbers: docs/estimators/navigation.md.
namespace drydock::navigation {

/// Over `dt` seconds that begin at some instant, in the body axes of that instant.
struct Increments {
  Eigen::Vector3d rotation = Eigen::Vector3d::Zero();  ///< rotation vector against inertial, rad
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< integral of specific force, m/s
  double dt = 0;
};

/// Savage's two-speed algorithm: as many samples a step as one likes, one among them.
class IncrementSum {
 public:
  /// The next sample: integrals of angular rate (rad) and specific force (m/s) over `dt`.
  void add(const Eigen::Vector3d& angle, const Eigen::Vector3d& velocity, double dt);

  /// The rotation since the step began, without the coning term: good to 1e-9 rad under way.
  const Eigen::Vector3d& angle() const { return angle_; }
  double dt() const { return dt_; }
  int samples() const { return samples_; }

  /// Eq. (N3), (N4); the next step begins.
  Increments take();

 private:
  using Vector = Eigen::Vector3d;
  Vector angle_ = Vector::Zero(), velocity_ = Vector::Zero();
  Vector coning_ = Vector::Zero(), sculling_ = Vector::Zero();
  Vector last_angle_ = Vector::Zero(), last_velocity_ = Vector::Zero();
  double dt_ = 0;
  int samples_ = 0;
};

}  // namespace drydock::navigation
