#pragma once

#include <cstdint>

#include "estimators/navigation/innovation.hpp"
#include "estimators/navigation/innovation_tally.hpp"
#include "estimators/velocity/simulator.hpp"

/// Velocity through the water by Lee, Ra, Kim, Ahn and Lee (2016): a vehicle simulator, and a
/// Kalman filter that estimates its errors. Equation numbers are those of
/// docs/estimators/velocity.md.
namespace drydock::velocity {

/// All sigmas are one standard deviation. Defaults: Tables 2 and 3 of the paper.
struct VelocityFilterOptions {
  double height_sigma_m = 1, velocity_sigma_mps = 1, rate_sigma_radps = 0.0174532925;  ///< P0
  /// Q: standard deviation of the change over one step, divided by the length of the step.
  double height_noise_mps = 0.1;
  Eigen::Vector3d velocity_noise_mps2{0.2, 0.5e-3, 0.125e-3};
  double rate_noise_radps2 = 0.00174532925;
  double depth_sigma_m = 0.5, log_sigma_mps = 0.03, ground_sigma_mps = 0.03;
  double gyro_sigma_radps = 1.16e-6;  ///< angle random walk at 100 Hz
  double gate_sigma = 0;  ///< depth, log and DVL values with more sigmas are refused; 0: no gate
};

/// The 7-state filter (8)-(12) in a form that feeds its corrections into the simulator. If a() is
/// evaluated exactly, its numbers are those of the paper. Each sensor has its own rows and may
/// arrive at any time. Allocates nothing, throws nothing; inputs must be finite. `Real`: a double,
/// or several runs side by side, which have no gate and note no innovations.
template <class Real>
class BasicVelocityFilter {
 public:
  using Vector3 = Eigen::Vector3<Real>;

  BasicVelocityFilter(const hydrodynamics::BasicModel<Real>& model,
                      const BasicSimulated<Real>& start, const VelocityFilterOptions& options = {});

  /// Begins anew, with this covariance of the three velocities and the other sigmas of the options.
  void restart(const BasicSimulated<Real>& at, const Eigen::Matrix3<Real>& velocity_covariance);

  void predict(const BasicSetting<Real>& setting, const hydrodynamics::Control& control,
               double dt);  ///< (12)

  bool update_height(const Real& height_m);       ///< rows of (10), (11); true: inside the gate
  void update_log(const Real& speed_mps);         ///< |V| through the water
  void update_longitudinal(const Real& mps);      ///< u through the water
  void update_rate(const Vector3& rate);          ///< against the Earth, body, rad/s
  void update_velocity(const Vector3& velocity);  ///< of a DVL, body, m/s

  Vector3 velocity() const { return simulator_.state().velocity.template head<3>(); }
  const BasicSimulated<Real>& state() const { return simulator_.state(); }

  std::uint64_t rejected() const { return rejected_; }                 ///< values outside the gate
  const navigation::InnovationTally& taken() const { return taken_; }  ///< values inside it
  /// Innovations of the last value of depth (up, m), log (m/s) or DVL (body axes, m/s).
  const navigation::Innovations& innovations() const { return innovations_; }

  /// Covariance of h, u v w, p q r. The eighth row and column are zero and fill the SIMD words.
  using Covariance = Eigen::Matrix<Real, 8, 8>;
  const Covariance& covariance() const { return p_; }
  Vector3 velocity_sigma() const { return p_.diagonal().template segment<3>(1).cwiseSqrt(); }

 private:
  using Vector = Eigen::Matrix<Real, 8, 1>;
  bool passes(const Real& residual, const Real& innovation_variance);
  bool update_state(int index, const Real& residual, double sigma);  ///< true: inside the gate
  void apply(const Vector& cross, const Real& innovation_variance, const Real& residual);

  BasicSimulator<Real> simulator_;
  VelocityFilterOptions options_;
  Covariance p_ = Covariance::Zero();
  std::uint64_t rejected_ = 0;
  navigation::InnovationTally taken_;
  navigation::Innovations innovations_;
};
using VelocityFilter = BasicVelocityFilter<double>;

}  // namespace drydock::velocity
