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

/// The same of any number.
template <class Real>
Eigen::Matrix<Real, 15, 1> basic_initial_sigma(const NavigationOptions& options,
                                               const frame::BasicPosition<Real>& at);

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
template <class Real>
Eigen::Matrix<Real, 3, 6> body_velocity_rows(const BasicNavigationState<Real>& state);

/// Allocates nothing, throws nothing; inputs must be finite. `Real`: a double, or several runs side
/// by side, which have no gate; they have the functions of aided_navigation_body.hpp.
template <class Real>
class BasicAidedNavigation {
 public:
  using Vector3 = Eigen::Vector3<Real>;
  using Filter = ErrorFilter<0, Real>;

  BasicAidedNavigation(const BasicNavigationState<Real>& start, const NavigationOptions& options);

  /// An IMU sample: integrals of angular rate (rad) and specific force (m/s) over `dt`.
  void add_imu(const Vector3& angle, const Vector3& velocity, double dt);

  /// The navigation step over the samples since the last step, and eq. (15).
  void step(std::optional<Real> reference_height_m = {});

  /// Adds noise beyond that of the options to the samples since the last step: one standard
  /// deviation of the angle (rad) and of the velocity (m/s), body axes.
  void add_noise(const Vector3& angle, const Vector3& velocity);

  /// Eq. (16). These functions correct the state at once and return the number of rows inside the
  /// gate. Standard deviations in body axes m/s; in m; in m north, east, up.
  /// `lever`: from the IMU to the sensor, body axes, m, eq. (N8).
  int update_velocity(const Vector3& velocity_body, const Vector3& sigma,
                      const Vector3& lever = Vector3::Zero());
  int update_height(const Real& height_m, double sigma, const Vector3& lever = Vector3::Zero());
  int update_position(const frame::Position& position, const Vector3& sigma,
                      const Vector3& lever = Vector3::Zero());

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

  const BasicNavigationState<Real>& state() const { return sdins_.state(); }
  /// Eq. (15) over the last step: F at its end, of which covariance() was propagated.
  BasicErrorDynamics<Real> dynamics() const {
    return error_dynamics(sdins_.state(), sdins_.force_ned(), sdins_.loop());
  }
  /// The attitude including the samples since the last step.
  Eigen::Quaternion<Real> body_to_ned() const {
    return sdins_.state().body_to_ned * quaternion_of<Real>(sum_.angle());
  }
  /// Rotation of the Earth in NED at the end of the last step, rad/s.
  const Vector3& earth_rate_ned() const { return earth_rate_ned_; }
  const Vector3& gyro_bias() const { return gyro_bias_; }
  const Vector3& accel_bias() const { return accel_bias_; }
  const typename Filter::Covariance& covariance() const { return filter_.covariance(); }

  /// Innovations of the last update or passes_height(): body axes m/s; up m; north, east, down m;
  /// clockwise rad.
  const Innovations& innovations() const { return innovations_; }
  double innovation_square() const;                        ///< sum of the normalised squares
  std::uint64_t rejected() const { return rejected_; }     ///< all rows outside the gate
  const InnovationTally& taken() const { return taken_; }  ///< all rows inside the gate

 private:
  using Vector = typename Filter::Vector;
  /// `unit`: the row's unit per unit of the reported innovation.
  int update_row(const Vector& row, const Real& residual, const Real& variance, Vector& errors,
                 double unit = 1);
  bool passes(double innovation, double variance, double unit);
  void feed_back(const Vector& errors);

  NavigationOptions options_;
  BasicSdins<Real> sdins_;
  BasicIncrementSum<Real> sum_;
  Filter filter_;
  Vector noise_;
  Vector3 earth_rate_ned_;
  Vector3 gyro_bias_ = Vector3::Zero(), accel_bias_ = Vector3::Zero();
  Vector3 rate_ = Vector3::Zero();  ///< mean over the last step, rad/s
  Innovations innovations_;
  std::uint64_t rejected_ = 0;
  InnovationTally taken_;
};
using AidedNavigation = BasicAidedNavigation<double>;

}  // namespace drydock::navigation
