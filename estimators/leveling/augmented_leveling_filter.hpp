#pragma once

#include <Eigen/Core>

#include "estimators/leveling/earth_rate.hpp"
#include "estimators/leveling/level_kinematics.hpp"
#include "estimators/leveling/leveling_options.hpp"
#include "estimators/leveling/speed_gate.hpp"

namespace drydock::leveling {

/// The leveling filter with the biases of its sensors as states: eq. (A1)-(A6) of
/// docs/estimators/leveling.md. A bias is fixed to the body, so a turn rotates it against the
/// horizon and the filter can tell bias from tilt. Its covariance is consistent; that of the six
/// states is not. It has the same member functions as LevelingFilter. Allocates nothing, throws
/// nothing; inputs must be finite.
class AugmentedLevelingFilter {
 public:
  /// [V (3) alpha (3) accelerometer bias (3) gyro bias (3) log bias]: m/s, -, m/s2, rad/s, m/s.
  /// A bias is the sensor's value minus the true value.
  static constexpr int states = 13;
  using State = Eigen::Matrix<double, states, 1>;
  using Covariance = Eigen::Matrix<double, states, states>;

  explicit AugmentedLevelingFilter(const LevelingOptions& options);

  /// Begins without knowledge of the biases. The heading is kept.
  void start(const Eigen::Vector3d& specific_force, const Eigen::Vector3d& angular_rate,
             double speed_mps);

  /// As in LevelingFilter, but the bias estimates are kept. The heading is uncertain, so the
  /// Earth's rate is too; this uncertainty is added to that of the gyro biases, (A8).
  void start_again(const Eigen::Vector3d& specific_force, const Eigen::Vector3d& angular_rate,
                   double speed_mps, double silent_s);

  /// Adds these standard deviations to V and alpha, per axis, because samples are missing.
  void loosen(double velocity_sigma_mps, double angle_sigma_rad);

  /// The biases of gyros (rad/s) and accelerometers (m/s2) may have changed by these standard
  /// deviations, per axis.
  void loosen_biases(double rate_sigma_radps, double force_sigma_mps2);

  /// Eq. (A2), (A3) over dt seconds with constant inputs (m/s2 and rad/s, body).
  void predict(const Eigen::Vector3d& specific_force, const Eigen::Vector3d& angular_rate,
               double dt);

  /// Eq. (A4): the log with its bias, and |alpha|^2 = 1. A speed outside the gate is not used.
  /// `trusted` = false: neither is this one, but innovation() compares it.
  void update_moving(double speed_mps, bool trusted = true);

  /// The log may have changed by this standard deviation.
  void loosen_log(double speed_sigma_mps);

  /// A DVL: velocity over ground along a body axis, 0 to 2, and |alpha|^2 = 1. `used` = false: only
  /// compared. Gives the innovation.
  navigation::Innovation update_velocity(int axis, double speed_mps, double sigma_mps, bool used);

  void update_stationary();             ///< eq. (32): V = 0, without the log, and |alpha|^2 = 1
  void update_nonholonomic(double dt);  ///< as in LevelingFilter

  double roll() const;   ///< eq. (28), (-pi, pi]
  double pitch() const;  ///< eq. (28), [-pi/2, pi/2]
  double heading() const {
    return heading_;
  }  ///< the given heading plus the gyro's turn, (-pi, pi]
  Eigen::Matrix2d roll_pitch_covariance() const;  ///< rad2

  Eigen::Vector3d accelerometer_bias() const { return x_.segment<3>(6); }
  Eigen::Vector3d gyro_bias() const { return x_.segment<3>(9); }
  double speed_bias() const { return x_(12); }

  const State& state() const { return x_; }
  const Covariance& covariance() const { return p_; }
  const Innovation& innovation() const { return innovation_; }
  const ConstraintInnovations& constraints() const { return constraints_; }
  std::uint64_t rejected() const {
    return gate_.rejected();
  }  ///< number of speeds outside the gate
  const LevelingOptions& options() const { return options_; }

 private:
  void start_motion(const FirstAlpha& first, double turn_radps, double speed_mps);
  void widen_gyro_bias();
  void let_biases_wander(double dt);
  void begin_update() { innovation_ = {}; }
  void update(double residual, const State& row, double variance);
  void update_norm();

  LevelingOptions options_;
  double gravity_;
  EarthRate earth_rate_;
  double heading_;
  double turn_ = 0;  ///< rad/s about body z, of the last prediction
  State x_ = State::Zero();
  Covariance p_ = Covariance::Zero();
  Innovation innovation_;
  ConstraintInnovations constraints_;
  SpeedGate gate_;
};

}  // namespace drydock::leveling
