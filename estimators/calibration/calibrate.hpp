#pragma once

#include <string>

#include "estimators/calibration/parameter.hpp"
#include "estimators/smoothing/noise_fit.hpp"

namespace drydock::calibration {

/// How well a dive tells a parameter: sigma below 0.3 of the prior's is told, below 0.7 weakly. A
/// search that did not settle tells none, a value beyond 3 sigmas of its prior is not told.
enum class Verdict : std::uint8_t { told, weakly, not_told };

struct Finding {
  Parameter parameter;
  double value = 0, sigma = 0;
  Verdict verdict = Verdict::not_told;
  std::string why;         ///< in words, where it is not told; may name another parameter by index
  int confused_with = -1;  ///< index of a parameter with a correlation beyond 0.9; -1: none

  double bound() const { return 1.96 * sigma; }  ///< 95 %
};

struct Calibration {
  std::vector<Finding> findings;  ///< in the order of the parameters
  Eigen::MatrixXd correlation;
  smoothing::LevelOptions options;  ///< with the found values and the fitted motion
  std::vector<double> noise_factors;
  int iterations = 0;
  bool converged = false;
};

/// Tells nothing if the search did not settle, and why of what is not told. A reason that stands
/// there stays.
void judge(Calibration& result);

/// Finds the parameters jointly by maximum likelihood of the smoother's forward filter. `dive`: its
/// unstated noise is scaled to what was fitted. The heading's constant bias and the scales
/// are no states here: parameters hold them. A parameter that no reading tells stays 0. `fit`: fit
/// the noise before and after a first calibration.
Calibration calibrate(smoothing::Dive& dive, smoothing::LevelOptions options,
                      const std::vector<Parameter>& parameters,
                      const std::vector<smoothing::UnstatedNoise>& unstated, bool fit = true);

}  // namespace drydock::calibration
