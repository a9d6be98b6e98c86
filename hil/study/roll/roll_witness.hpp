#pragma once

#include <Eigen/Core>
#include <span>

#include "estimators/roll/all_satellites.hpp"
#include "hil/study/roll/roll_case.hpp"

namespace drydock::study {

/// No estimator, for it knows the truth: the all-satellite filter's measurement update linearised
/// there, on the same noises. What it makes of a run, an efficient estimator makes of it; a run in
/// which it is bad had bad luck. docs/estimators/roll.md, The bound.
class RollWitness {
 public:
  /// `options` and `bias_radps`: of the filter that it stands beside, and of its gyro.
  RollWitness(const RollCase& the_case, const RollFlight& flight,
              const roll::AllSatellitesOptions& options, double bias_radps);

  /// By how much the gyro's rate is wrong beside its bias, over dt.
  void predict(double rate_noise_radps, double dt);
  void update(double t, std::span<const roll::Signal> signals);

  double roll_error() const { return error_(0); }  ///< rad

 private:
  const RollFlight* flight_;
  roll::AllSatellitesOptions options_;
  Eigen::VectorXd error_;  ///< estimate less truth: roll, gyro bias, common gain, gains
  Eigen::MatrixXd p_;
};

}  // namespace drydock::study
