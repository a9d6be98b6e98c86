#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "estimators/hydrodynamics/vehicle.hpp"
#include "estimators/navigation/aided_navigation.hpp"
#include "estimators/velocity/sway_model.hpp"

/// The velocity filter of this project: one filter over inertial navigation, water and vehicle.
/// Each sensor is a measurement of the quantity that it measures. docs/estimators/velocity.md says
/// why.
namespace drydock::velocity {

/// All values are one standard deviation. They are chosen unless the line names a source; the docs
/// page says why.
struct CoupledOptions {
  navigation::NavigationOptions
      navigation;  ///< its height loop is not used; the depth is a measurement
  double depth_sigma_m = 0.5, log_sigma_mps = 0.03, ground_sigma_mps = 0.03;  ///< paper, Table 2
  double current_mps = 0.5;                      ///< north and east, each
  double log_scale = 0.01, log_bias_mps = 0.01;  ///< measured speed = (1 + scale) |V| + bias
  double force_error = 0.2;                      ///< of each cause of the sway force, relative
  double sway_noise_m = 0.005;                   ///< of the sway equation, m/s sqrt(s)
  double ground_lost_s = 5;  ///< after this time without a DVL the hypotheses are weighed
};

/// States of the filter after the 15 of the navigation; errors are estimate minus truth.
enum CoupledState { current_error = 15, log_error = 17, force_error = 19 };

template <class Real>
class BasicCoupledNavigation {
 public:
  using Filter = navigation::ErrorFilter<7, Real>;
  using Vector3 = Eigen::Vector3<Real>;
  using Sway = BasicSwayModel<Real>;
  using State = navigation::BasicNavigationState<Real>;

  BasicCoupledNavigation(const State& start, const hydrodynamics::BasicVehicle<Real>& vehicle,
                         const CoupledOptions& options);

  /// An IMU sample: integrals of angular rate (rad) and specific force (m/s) over `dt`.
  void add_imu(const Vector3& angle, const Vector3& velocity, double dt) {
    sum_.add(angle - gyro_bias_ * dt, velocity - accel_bias_ * dt, dt);
  }

  /// The height (up) of a depth sensor at the time of the last IMU sample. The next step uses it.
  void add_height(const Real& height_m) {
    innovations_.clear();
    const Real at_start = height_m + sdins_.state().velocity_ned.z() * sum_.dt();
    if constexpr (lanes::alone<Real>) {
      if (!passes_height(at_start)) return;
    }
    height_sum_ += at_start;
    ++heights_;
  }

  /// Propagates navigation, covariance and sway over the samples since the last step (0.2 s at
  /// most). Then updates with the sway equation as a measurement, eq. (V6).
  void step(const hydrodynamics::Control& control);

  void update_log(const Real& speed_mps);              ///< |V| through the water, (V7)
  void update_longitudinal(const Real& mps);           ///< u through the water, (V7a)
  void update_velocity(const Vector3& velocity_body);  ///< over ground, body

  /// Adds these standard deviations to velocity and attitude, each axis.
  void loosen(double velocity_sigma_mps, double angle_sigma_rad) {
    filter_.loosen(velocity_sigma_mps, angle_sigma_rad);
  }
  void loosen_position(double sigma_m) {
    filter_.loosen_position(sdins_.state().position, sigma_m);
  }
  void loosen_biases(double gyro_sigma_radps, double accel_sigma_mps2) {
    filter_.loosen_biases(gyro_sigma_radps, accel_sigma_mps2);
  }

  const State& state() const { return sdins_.state(); }
  const typename Filter::Covariance& covariance() const { return filter_.covariance(); }
  const Eigen::Vector2<Real>& current_ned() const { return current_; }  ///< north, east
  Real log_scale() const { return log_(0); }
  Real log_bias_mps() const { return log_(1); }
  const Sway& sway() const { return sway_; }
  const Vector3& gyro_bias() const { return gyro_bias_; }
  /// Values of log, DVL and depth outside `navigation.gate_sigma`.
  std::uint64_t rejected() const { return rejected_; }
  const navigation::InnovationTally& taken() const { return taken_; }  ///< values inside it
  /// Innovations of the last value of log (m/s), DVL (body axes, m/s) or depth (up, m).
  const navigation::Innovations& innovations() const { return innovations_; }

 private:
  using Vector = typename Filter::Vector;
  Vector3 velocity_through_water() const;
  /// Derivatives of C_n^b (V - current) by velocity, phi and current.
  Eigen::Matrix<Real, 3, Filter::stored> water_rows() const;
  void update(const Vector& row, const Real& residual, double variance);
  bool passes(double innovation, double variance);
  bool passes_height(double height_m);
  /// `row`: the derivatives of the quantity of the log by the states before those of the log;
  /// `value`: the present estimate of this quantity, m/s.
  void update_by_log(Vector row, const Real& value, const Real& measured_mps);
  void feed_back(const Vector& errors);
  void update_height(const Real& sinking_m);  ///< over the step
  void weigh_hypotheses();
  void reopen_hypotheses();

  CoupledOptions options_;
  navigation::BasicSdins<Real> sdins_;
  navigation::BasicIncrementSum<Real> sum_;
  Filter filter_;
  Vector noise_;
  Sway sway_;
  Vector3 gyro_bias_ = Vector3::Zero(), accel_bias_ = Vector3::Zero();
  Eigen::Vector2<Real> current_ = Eigen::Vector2<Real>::Zero(), log_ = Eigen::Vector2<Real>::Zero();
  Vector3 last_rate_ = Vector3::Zero();
  Real height_sum_ = 0;  ///< heights at the start of the step
  int heights_ = 0;
  bool moving_ = false;  ///< after the first step
  std::uint64_t rejected_ = 0;
  navigation::InnovationTally taken_;
  navigation::Innovations innovations_;
  double since_ground_s_ = -1;  ///< -1: no DVL value yet, or none since the weighing
  struct Open {
    Eigen::Vector4<Real> values;  ///< current, log
    Eigen::Matrix4<Real> covariance;
  };
  std::optional<Open> open_;  ///< estimates before the weighing, while the mixture is in use
};
using CoupledNavigation = BasicCoupledNavigation<double>;

}  // namespace drydock::velocity
