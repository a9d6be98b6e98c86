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
  double height_noise_m = 0.01;   ///< sensor noise that passes the height loop; chosen
  double height_loop_tau_s = 30;  ///< 0: no height loop; chosen
  double gate_sigma = 0;          ///< rows with a larger innovation are refused; 0: no gate
};

using Vector15 = Eigen::Matrix<double, 15, 1>;

/// Standard deviations of the errors at the start, in the order of eq. (14).
Vector15 initial_sigma(const NavigationOptions& options, const frame::Position& at);

/// Diagonal of Q, eq. (15), per second.
Vector15 noise_density(const NavigationOptions& options);

HeightLoop height_loop(const NavigationOptions& options);

/// Eq. (N9): heading of body x, and its derivative by phi. `level`: cosine of the bow's elevation.
struct HeadingRow {
  double heading_rad, level;
  Eigen::RowVector3d by_phi;
};
HeadingRow heading_row(const Eigen::Quaterniond& body_to_ned);

/// Rows of eq. (16) for the velocity in body axes: d(C_N^B V^N) by velocity and phi, 3 x 6.
Eigen::Matrix<double, 3, 6> body_velocity_rows(const NavigationState& state);

/// Allocates nothing, throws nothing; inputs must be finite.
class AidedNavigation {
 public:
  AidedNavigation(const NavigationState& start, const NavigationOptions& options);

  /// An IMU sample: integrals of angular rate (rad) and specific force (m/s) over `dt`.
  void add_imu(const Eigen::Vector3d& angle, const Eigen::Vector3d& velocity, double dt);

  /// The navigation step over the samples since the last step, and eq. (15).
  void step(std::optional<double> reference_height_m = {});

  /// Adds noise beyond that of the options to the samples since the last step: one standard
  /// deviation of the angle (rad) and of the velocity (m/s), body axes.
  void add_noise(const Eigen::Vector3d& angle, const Eigen::Vector3d& velocity);

  /// Eq. (16). These functions correct the state at once and return the number of rows inside the
  /// gate. Standard deviations in body axes m/s; in m; in m north, east, up.
  /// `lever`: from the IMU to the sensor, body axes, m, eq. (N8).
  int update_velocity(const Eigen::Vector3d& velocity_body, const Eigen::Vector3d& sigma,
                      const Eigen::Vector3d& lever = Eigen::Vector3d::Zero());
  int update_height(double height_m, double sigma,
                    const Eigen::Vector3d& lever = Eigen::Vector3d::Zero());
  int update_position(const frame::Position& position, const Eigen::Vector3d& sigma,
                      const Eigen::Vector3d& lever = Eigen::Vector3d::Zero());

  /// True heading of body x, rad: eq. (N9). Does nothing while the bow points within 6 degrees of
  /// up or down, where it has no heading.
  int update_heading(double heading_rad, double sigma);

  /// True if a height that is `residual_m` above the state's is inside the gate. Counts it if not.
  bool passes_height(double residual_m, double sigma);

  /// Adds these standard deviations to velocity and attitude, each axis.
  void loosen(double velocity_sigma_mps, double angle_sigma_rad);
  /// Likewise to the horizontal position, north and east; and to the biases of the IMU.
  void loosen_position(double sigma_m);
  void loosen_biases(double gyro_sigma_radps, double accel_sigma_mps2);

  const NavigationState& state() const { return sdins_.state(); }
  /// Eq. (15) over the last step: F at its end, of which covariance() was propagated.
  ErrorDynamics dynamics() const {
    return error_dynamics(sdins_.state(), sdins_.force_ned(), sdins_.loop());
  }
  /// The attitude including the samples since the last step.
  Eigen::Quaterniond body_to_ned() const {
    return sdins_.state().body_to_ned * quaternion_of(sum_.angle());
  }
  const Eigen::Vector3d& gyro_bias() const { return gyro_bias_; }
  const Eigen::Vector3d& accel_bias() const { return accel_bias_; }
  const ErrorFilter<0>::Covariance& covariance() const { return filter_.covariance(); }

  /// Innovations of the last update or passes_height(): body axes m/s; up m; north, east, down m;
  /// clockwise rad.
  const Innovations& innovations() const { return innovations_; }
  double innovation_square() const;                        ///< sum of the normalised squares
  std::uint64_t rejected() const { return rejected_; }     ///< all rows outside the gate
  const InnovationTally& taken() const { return taken_; }  ///< all rows inside the gate

 private:
  using Vector = ErrorFilter<0>::Vector;
  /// `unit`: the row's unit per unit of the reported innovation.
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
