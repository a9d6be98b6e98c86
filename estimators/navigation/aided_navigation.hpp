#pragma once

#include <cstdint>
#include <optional>

#include "estimators/navigation/error_filter.hpp"
#include "estimators/navigation/innovation.hpp"
#include "estimators/navigation/innovation_tally.hpp"

/// SDINS with its 15-state aiding filter, eq. (13)-(16) of docs/estimators/navigation.md.
namespace drydock::navigation {

/// One standard deviation each; densities per sqrt(s). Defaults: Table 2 of the paper.
struct NavigationOptions {
  double position_m = 10, height_m = 1, velocity_mps = 0.1;        ///< at the start
  Eigen::Vector3d alignment_rad{2.9089e-6, 2.9089e-6, 8.7266e-6};  ///< N E D; .01 .01 .03 arcmin
  double gyro_bias_radps = 9.6963e-9;                              ///< 2 mdeg/h
  double accel_bias_mps2 = 3.92266e-5;                             ///< 4 ug
  double angle_noise_rad = 1.16355e-7;                             ///< .4 mdeg per sqrt(h)
  double velocity_noise_mps = 3.92266e-5;                          ///< 4 ug sqrt(s)
  double gyro_bias_walk_radps = 0, accel_bias_walk_mps2 = 0;
  double height_noise_m = 0.01;   ///< what the height loop lets through of its sensor; chosen
  double height_loop_tau_s = 30;  ///< 0: no height loop; chosen
  double gate_sigma = 0;          ///< rows whose innovation is further out are refused; 0: none are
};

using Vector15 = Eigen::Matrix<double, 15, 1>;

/// Of the errors at the start, in the order of eq. (14).
Vector15 initial_sigma(const NavigationOptions& options, const frame::Position& at);

/// Diagonal of Q, eq. (15), per second.
Vector15 noise_density(const NavigationOptions& options);

HeightLoop height_loop(const NavigationOptions& options);

/// Rows of eq. (16) for the velocity in body axes: d(C_N^B V^N) by velocity and phi, 3 x 6.
Eigen::Matrix<double, 3, 6> body_velocity_rows(const NavigationState& state);

/// Allocates nothing, throws nothing; inputs must be finite.
class AidedNavigation {
 public:
  AidedNavigation(const NavigationState& start, const NavigationOptions& options);

  /// An IMU sample: integrals of angular rate (rad) and specific force (m/s) over `dt`.
  void add_imu(const Eigen::Vector3d& angle, const Eigen::Vector3d& velocity, double dt);

  /// The navigation step over the samples since the last one, and eq. (15).
  void step(std::optional<double> reference_height_m = {});

  /// What a sample since the last step may miss beyond the options' noise: one standard deviation
  /// each of its angle (rad) and velocity (m/s), body axes.
  void add_noise(const Eigen::Vector3d& angle, const Eigen::Vector3d& velocity);

  /// Eq. (16). Give the number of rows that passed the gate; errors found are taken out at once.
  /// Standard deviations in body axes m/s, m, and m north, east, up.
  /// `lever`: from the IMU to the sensor, body axes, m, eq. (N8).
  int update_velocity(const Eigen::Vector3d& velocity_body, const Eigen::Vector3d& sigma,
                      const Eigen::Vector3d& lever = Eigen::Vector3d::Zero());
  int update_height(double height_m, double sigma,
                    const Eigen::Vector3d& lever = Eigen::Vector3d::Zero());
  int update_position(const frame::Position& position, const Eigen::Vector3d& sigma,
                      const Eigen::Vector3d& lever = Eigen::Vector3d::Zero());

  /// Whether a single height, so much above the state's, is inside the gate; counted if not.
  bool passes_height(double residual_m, double sigma);

  /// Velocity and attitude have become less certain by so much, each axis.
  void loosen(double velocity_sigma_mps, double angle_sigma_rad);

  const NavigationState& state() const { return sdins_.state(); }
  /// With the samples that wait for their step.
  Eigen::Quaterniond body_to_ned() const {
    return sdins_.state().body_to_ned * quaternion_of(sum_.angle());
  }
  const Eigen::Vector3d& gyro_bias() const { return gyro_bias_; }
  const Eigen::Vector3d& accel_bias() const { return accel_bias_; }
  const ErrorFilter<0>::Covariance& covariance() const { return filter_.covariance(); }

  /// Of the last update or passes_height(): body axes m/s; up m; north, east, down m.
  const Innovations& innovations() const { return innovations_; }
  double innovation_square() const;                        ///< normalised, of all of them
  std::uint64_t rejected() const { return rejected_; }     ///< rows outside the gate, ever
  const InnovationTally& taken() const { return taken_; }  ///< rows inside it, ever

 private:
  using Vector = ErrorFilter<0>::Vector;
  /// `unit`: what the row has where its innovation has 1.
  int update_row(const Vector& row, double residual, double variance, Vector& errors,
                 double unit = 1);
  void feed_back(const Vector& errors);

  NavigationOptions options_;
  Sdins sdins_;
  IncrementSum sum_;
  ErrorFilter<0> filter_;
  Vector noise_;
  Eigen::Vector3d gyro_bias_ = Eigen::Vector3d::Zero(), accel_bias_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d rate_ = Eigen::Vector3d::Zero();  ///< mean over the last step, rad/s
  Innovations innovations_;
  std::uint64_t rejected_ = 0;
  InnovationTally taken_;
};

}  // namespace drydock::navigation
