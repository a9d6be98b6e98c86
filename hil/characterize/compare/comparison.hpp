#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hil/characterize/estimate.hpp"

namespace drydock::characterize {

/// Values of one quantity in time order.
struct Signal {
  std::vector<double> t_s, value;
};

/// A sensor's signal compared with a reference's: y(t) = scale x(t - delay) + bias (+ drift t).
struct Comparison {
  std::string what;  ///< "speed over ground", "x"
  std::size_t blocks = 0;
  std::optional<Estimate> scale;      ///< 1 is right; empty: the reference hardly changed
  std::optional<Estimate> angle_rad;  ///< a DVL about its z axis: see VelocityComparison
  std::optional<Estimate> delay_s;    ///< after the reference, by both drivers' valid_at
  Estimate bias;                      ///< at zero input if the scale is known; else at the input
                                      ///< that there was
  std::optional<Estimate> drift;      ///< per second, only on request
  double residual = 0;                ///< rms over the means of blocks
};

/// Least squares over the means of common blocks of time. The reference's own noise is estimated
/// from second differences and removed from the normal equations (W. A. Fuller, Measurement Error
/// Models, 1987, section 1.2). Serial correlation of the residuals widens the bounds. Empty if
/// there are fewer than ten common blocks.
std::optional<Comparison> compare(const Signal& sensor, const Signal& reference,
                                  bool with_drift = false);

}  // namespace drydock::characterize
