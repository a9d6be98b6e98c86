#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "estimators/hydrodynamics/vehicle.hpp"
#include "estimators/navigation/aided_navigation.hpp"
#include "estimators/velocity/sway_model.hpp"

/// Our answer to the paper's question: one filter over inertial navigation, water and vehicle, in
/// which every sensor counts as what it measures. docs/estimators/velocity.md says why.
namespace drydock::velocity {

/// One standard deviation each; chosen, where nothing else is said, as the docs page argues.
struct CoupledOptions {
  navigation::NavigationOptions navigation;  ///< its height loop is not used: depth is measured
  double depth_sigma_m = 0.5, log_sigma_mps = 0.03, ground_sigma_mps = 0.03;  ///< paper, Table 2
  double current_mps = 0.5;                      ///< each of north and east
  double log_scale = 0.01, log_bias_mps = 0.01;  ///< speed shown = (1 + scale) |V| + bias
  double force_error = 0.2;                      ///< of each cause of the sway force, relative
  double sway_noise_m = 0.005;                   ///< of the sway equation, m/s sqrt(s)
  double ground_lost_s = 5;  ///< so long without a DVL, the hypotheses are weighed
};

/// States of the filter after the 15 of the navigation; errors are estimate minus truth.
enum CoupledState { current_error = 15, log_error = 17, force_error = 19 };

class CoupledNavigation {
 public:
  using Filter = navigation::ErrorFilter<7>;

  CoupledNavigation(const navigation::NavigationState& start, const hydrodynamics::Vehicle& vehicle,
                    const CoupledOptions& options);

  /// An IMU sample: integrals of angular rate (rad) and specific force (m/s) over `dt`.
  void add_imu(const Eigen::Vector3d& angle, const Eigen::Vector3d& velocity, double dt) {
    sum_.add(angle - gyro_bias_ * dt, velocity - accel_bias_ * dt, dt);
  }

  /// A depth sensor's height (up) at the time of the last IMU sample; used with the next step.
  void add_height(double height_m) {
    innovations_.clear();
    const double at_start = height_m + sdins_.state().velocity_ned.z() * sum_.dt();
    if (!passes_height(at_start)) return;
    height_sum_ += at_start;
    ++heights_;
  }

  /// Navigation, covariance and sway over the samples since the last step (0.2 s at most), then
  /// the sway equation as a measurement, eq. (V6).
  void step(const hydrodynamics::Control& control);

  void update_log(double speed_mps);                           ///< |V| through the water, (V7)
  void update_longitudinal(double mps);                        ///< u through the water, (V7a)
  void update_velocity(const Eigen::Vector3d& velocity_body);  ///< over ground, body

  /// Velocity and attitude have become less certain by so much, each axis.
  void loosen(double velocity_sigma_mps, double angle_sigma_rad) {
    filter_.loosen(velocity_sigma_mps, angle_sigma_rad);
  }

  const navigation::NavigationState& state() const { return sdins_.state(); }
  const Filter::Covariance& covariance() const { return filter_.covariance(); }
  const Eigen::Vector2d& current_ned() const { return current_; }  ///< north, east
  double log_scale() const { return log_(0); }
  double log_bias_mps() const { return log_(1); }
  const SwayModel& sway() const { return sway_; }
  const Eigen::Vector3d& gyro_bias() const { return gyro_bias_; }
  /// Values of log, DVL and depth outside `navigation.gate_sigma`.
  std::uint64_t rejected() const { return rejected_; }
  const navigation::InnovationTally& taken() const { return taken_; }  ///< those inside
  /// Of the last value of log, DVL or depth: m/s; body axes m/s; up m.
  const navigation::Innovations& innovations() const { return innovations_; }

 private:
  using Vector = Filter::Vector;
  Eigen::Vector3d velocity_through_water() const;
  /// d(C_n^b (V - current)) by velocity, phi and current.
  Eigen::Matrix<double, 3, Filter::stored> water_rows() const;
  void update(const Vector& row, double residual, double variance);
  bool passes(double innovation, double variance);
  bool passes_height(double height_m);
  /// A log's row: how its quantity, now `value` m/s, depends on the states before the log's own.
  void update_by_log(Vector row, double value, double measured_mps);
  void feed_back(const Vector& errors);
  void update_height(double sinking_m);  ///< over the step
  void weigh_hypotheses();
  void reopen_hypotheses();

  CoupledOptions options_;
  navigation::Sdins sdins_;
  navigation::IncrementSum sum_;
  Filter filter_;
  Vector noise_;
  SwayModel sway_;
  Eigen::Vector3d gyro_bias_ = Eigen::Vector3d::Zero(), accel_bias_ = Eigen::Vector3d::Zero();
  Eigen::Vector2d current_ = Eigen::Vector2d::Zero(), log_ = Eigen::Vector2d::Zero();
  Eigen::Vector3d last_rate_ = Eigen::Vector3d::Zero();
  double height_sum_ = 0;  ///< carried back to the start of the step
  int heights_ = 0;
  bool moving_ = false;  ///< there has been a step
  std::uint64_t rejected_ = 0;
  navigation::InnovationTally taken_;
  navigation::Innovations innovations_;
  double since_ground_s_ = -1;  ///< -1: no DVL yet, or weighed since
  struct Open {
    Eigen::Vector4d values;  ///< current, log
    Eigen::Matrix4d covariance;
  };
  std::optional<Open> open_;  ///< before the hypotheses were weighed, while the mixture holds
};

}  // namespace drydock::velocity
