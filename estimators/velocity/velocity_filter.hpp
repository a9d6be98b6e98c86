#pragma once

#include <cstdint>

#include "estimators/navigation/innovation.hpp"
#include "estimators/navigation/innovation_tally.hpp"
#include "estimators/velocity/simulator.hpp"

/// Velocity through the water of Lee, Ra, Kim, Ahn and Lee (2016): a vehicle simulator whose errors
/// a Kalman filter finds. Equation numbers are those of docs/estimators/velocity.md.
namespace drydock::velocity {

/// One standard deviation each. Defaults: the paper's Tables 2 and 3.
struct VelocityFilterOptions {
  double height_sigma_m = 1, velocity_sigma_mps = 1, rate_sigma_radps = 0.0174532925;  ///< P0
  /// Q: of the change over one step, divided by its length.
  double height_noise_mps = 0.1;
  Eigen::Vector3d velocity_noise_mps2{0.2, 0.5e-3, 0.125e-3};
  double rate_noise_radps2 = 0.00174532925;
  double depth_sigma_m = 0.5, log_sigma_mps = 0.03, ground_sigma_mps = 0.03;
  double gyro_sigma_radps = 1.16e-6;  ///< angle random walk at 100 Hz
  double gate_sigma = 0;  ///< values of depth, log and DVL further out are refused; 0: none are
};

/// The 7-state filter (8)-(12) in the form that feeds its corrections into the simulator: with a()
/// taken exactly that is, number for number, the paper's. Each sensor has its own rows and comes
/// when it comes. Allocates nothing, throws nothing; inputs must be finite.
class VelocityFilter {
 public:
  VelocityFilter(const hydrodynamics::Model& model, const Simulated& start,
                 const VelocityFilterOptions& options = {});

  void predict(const Setting& setting, const hydrodynamics::Control& control, double dt);  ///< (12)

  bool update_height(double height_m);                    ///< rows of (10), (11); inside the gate?
  void update_log(double speed_mps);                      ///< |V| through the water
  void update_longitudinal(double mps);                   ///< u through the water
  void update_rate(const Eigen::Vector3d& rate);          ///< against the Earth, body, rad/s
  void update_velocity(const Eigen::Vector3d& velocity);  ///< a DVL's, body, m/s

  Eigen::Vector3d velocity() const { return simulator_.state().velocity.head<3>(); }
  const Simulated& state() const { return simulator_.state(); }

  std::uint64_t rejected() const { return rejected_; }                 ///< values outside the gate
  const navigation::InnovationTally& taken() const { return taken_; }  ///< those inside
  /// Of the last value of depth, log or DVL: up m; m/s; body axes m/s.
  const navigation::Innovations& innovations() const { return innovations_; }

  /// Of h, u v w, p q r; the eighth row and column are zero: a whole number of SIMD words.
  using Covariance = Eigen::Matrix<double, 8, 8>;
  const Covariance& covariance() const { return p_; }
  Eigen::Vector3d velocity_sigma() const { return p_.diagonal().segment<3>(1).cwiseSqrt(); }

 private:
  using Vector = Eigen::Matrix<double, 8, 1>;
  bool passes(double residual, double innovation_variance);
  bool update_state(int index, double residual, double sigma);  ///< inside the gate?
  void apply(const Vector& cross, double innovation_variance, double residual);

  Simulator simulator_;
  VelocityFilterOptions options_;
  Covariance p_ = Covariance::Zero();
  std::uint64_t rejected_ = 0;
  navigation::InnovationTally taken_;
  navigation::Innovations innovations_;
};

}  // namespace drydock::velocity
