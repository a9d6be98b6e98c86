#pragma once

#include <Eigen/Core>

#include "estimators/leveling/earth_rate.hpp"
#include "estimators/leveling/level_kinematics.hpp"
#include "estimators/leveling/leveling_options.hpp"
#include "estimators/leveling/speed_gate.hpp"

/// Roll and pitch from an inertial measurement unit and a speed log, without an initial attitude:
/// the extended Kalman filter of Hong, Park, Han and Lee, "A Leveling Algorithm for Strapdown INS
/// Using EKF" (2000). Equation numbers are those of docs/estimators/leveling.md.
namespace drydock::leveling {

/// State x = [V_x V_y V_z alpha_1 alpha_2 alpha_3]: velocity over the Earth in body axes, m/s, and
/// alpha = third column of C_n^b, "down" in body axes. Allocates nothing, throws nothing; inputs
/// must be finite (the pipeline checks them).
class LevelingFilter {
 public:
  using State = Vector6;
  using Covariance = Matrix6;

  explicit LevelingFilter(const LevelingOptions& options);

  /// Starts or restarts: the attitude as the options say, V = [speed 0 0]. The heading is kept.
  void start(const Eigen::Vector3d& specific_force, const Eigen::Vector3d& angular_rate,
             double speed_mps);

  /// Restarts after the IMU of a moving vehicle was silent for `silent_s`. As `start`, but the
  /// first attitude is more certain and the heading is less certain, (A7).
  void start_again(const Eigen::Vector3d& specific_force, const Eigen::Vector3d& angular_rate,
                   double speed_mps, double silent_s);

  /// Adds these standard deviations to V and alpha, per axis, because samples are missing.
  void loosen(double velocity_sigma_mps, double angle_sigma_rad);

  /// The biases of gyros (rad/s) and accelerometers (m/s2) may have changed by these standard
  /// deviations, per axis.
  void loosen_biases(double rate_sigma_radps, double force_sigma_mps2);

  /// Eq. (21), (22) over dt seconds with constant inputs (m/s2 and rad/s, body).
  void predict(const Eigen::Vector3d& specific_force, const Eigen::Vector3d& angular_rate,
               double dt);

  /// Eq. (29)-(31): speed along body x, and |alpha|^2 = 1. A speed outside the gate is not used.
  /// `trusted` = false: neither is this one, but innovation() compares it.
  void update_moving(double speed_mps, bool trusted = true);

  /// The log may have changed by this standard deviation.
  void loosen_log(double speed_sigma_mps);

  /// Eq. (32)-(34): all three velocities are zero, and |alpha|^2 = 1.
  void update_stationary();

  /// Applies the constraints that the options enable, for `dt` seconds of motion.
  void update_nonholonomic(double dt);

  double roll() const;   ///< eq. (28), (-pi, pi]
  double pitch() const;  ///< eq. (28), [-pi/2, pi/2]
  double heading() const {
    return heading_;
  }  ///< the given heading plus the gyro's turn, (-pi, pi]

  /// Covariance of [roll pitch], rad2: from that of alpha, with the Jacobian of eq. (28).
  Eigen::Matrix2d roll_pitch_covariance() const;

  const State& state() const { return x_; }
  const Covariance& covariance() const { return p_; }
  const Innovation& innovation() const { return innovation_; }
  const ConstraintInnovations& constraints() const { return constraints_; }
  std::uint64_t rejected() const {
    return gate_.rejected();
  }  ///< number of speeds outside the gate
  const LevelingOptions& options() const { return options_; }
  double gravity_mps2() const { return gravity_; }

 private:
  template <int Rows>
  void update(const Eigen::Matrix<double, Rows, 1>& residual,
              const Eigen::Matrix<double, Rows, 6>& h,
              const Eigen::Matrix<double, Rows, 1>& variance);

  void start_at(const FirstAlpha& first, double turn_radps, double speed_mps);
  Eigen::Vector3d earth_rate_body() const;

  LevelingOptions options_;
  double gravity_;
  EarthRate earth_rate_;
  double alpha_variance_;  ///< Q of alpha, 1/s
  double heading_;
  double turn_ = 0;  ///< rad/s about body z, of the last prediction
  State x_ = State::Zero();
  Covariance p_ = Covariance::Zero();
  Innovation innovation_;
  ConstraintInnovations constraints_;
  SpeedGate gate_;
};

}  // namespace drydock::leveling
