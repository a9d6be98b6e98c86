#pragma once

#include <Eigen/Core>

/// Sums the samples of an inertial measurement unit over a navigation step and corrects for coning
/// and sculling. Equation numbers: docs/estimators/navigation.md.
namespace drydock::navigation {

/// Increments over `dt` seconds, in the body axes at the begin of this interval.
template <class Real>
struct BasicIncrements {
  Eigen::Vector3<Real> rotation = Eigen::Vector3<Real>::Zero();  ///< against inertial, rad
  Eigen::Vector3<Real> velocity =
      Eigen::Vector3<Real>::Zero();  ///< integral of specific force, m/s
  double dt = 0;
};
using Increments = BasicIncrements<double>;

/// Savage's two-speed algorithm, for any number of samples per step from one on.
template <class Real>
class BasicIncrementSum {
 public:
  using Vector = Eigen::Vector3<Real>;

  /// The next sample: integrals of angular rate (rad) and specific force (m/s) over `dt`.
  void add(const Vector& angle, const Vector& velocity, double dt);

  /// The rotation since the start of the step without the coning term. The error of a moving
  /// vehicle is below 1e-9 rad.
  const Vector& angle() const { return angle_; }
  double dt() const { return dt_; }
  int samples() const { return samples_; }

  /// Eq. (N3), (N4). Starts the next step.
  BasicIncrements<Real> take();

 private:
  Vector angle_ = Vector::Zero(), velocity_ = Vector::Zero();
  Vector coning_ = Vector::Zero(), sculling_ = Vector::Zero();
  Vector last_angle_ = Vector::Zero(), last_velocity_ = Vector::Zero();
  double dt_ = 0;
  int samples_ = 0;
};
using IncrementSum = BasicIncrementSum<double>;

}  // namespace drydock::navigation
