#pragma once

#include <Eigen/Core>

namespace drydock::mixing {

/// Judges an attitude by the velocity that the accelerometers, turned level by it, give over the
/// last seconds: eq. (14) of docs/estimators/mixing.md. An attitude that is wrong by one degree
/// accelerates a vehicle sideways by .17 m/s2, and no vehicle moves so. Allocates nothing.
class SlipWatch {
 public:
  /// Two-sided 1e-7 of a standard normal value.
  static constexpr double limit = 5.3267;

  /// `span_s`: the velocity of about so many seconds counts.
  SlipWatch(double span_s, double gravity_mps2) : span_s_(span_s), gravity_(gravity_mps2) {}

  void start(double speed_mps);
  /// One step of `dt` seconds: specific force (m/s2) and rate (rad/s) in body axes; `down`: "down"
  /// in body axes at the estimated attitude; `speed_mps`: of the log.
  void step(const Eigen::Vector3d& force, const Eigen::Vector3d& rate, const Eigen::Vector3d& down,
            double speed_mps, double dt);

  /// Velocity that nothing explains, m/s: ahead, what the log does not say; across and down, all.
  const Eigen::Vector3d& slip() const { return slip_; }
  /// `tilt_sigma_rad`: how well the attitude is known against the vertical of the accelerometers.
  bool contradicts(double tilt_sigma_rad) const;

 private:
  double span_s_, gravity_;
  Eigen::Vector3d slip_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d rate_ = Eigen::Vector3d::Zero(), slow_rate_ = Eigen::Vector3d::Zero();
  double speed_mps_ = 0;
};

}  // namespace drydock::mixing
