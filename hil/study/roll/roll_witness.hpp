#pragma once

#include <Eigen/Core>
#include <span>

#include "estimators/roll/all_satellites.hpp"
#include "hil/study/roll/roll_case.hpp"

namespace drydock::study {

/// Not an estimator, because it knows the truth: the measurement update of the all-satellite
/// filter, linearised at the truth, with the same noises. An efficient estimator has the same error
/// in a run. If this error is large, the run was unlucky. docs/estimators/roll.md, The bound.
class RollWitness {
 public:
  /// `options` are those of the compared filter, and `bias_radps` is the bias of its gyro.
  RollWitness(const RollCase& the_case, const RollFlight& flight,
              const roll::AllSatellitesOptions& options, double bias_radps);

  /// `rate_noise_radps` is the error of the gyro's rate without its bias, over dt.
  void predict(double rate_noise_radps, double dt);
  void update(double t, std::span<const roll::Signal> signals);

  double roll_error() const { return error_(0); }  ///< rad

 private:
  const RollFlight* flight_;
  roll::AllSatellitesOptions options_;
  Eigen::VectorXd error_;  ///< estimate minus truth: roll, gyro bias, common gain, gains
  Eigen::MatrixXd p_;
};

}  // namespace drydock::study
