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

/// A sensor's signal against a reference's: y(t) = scale x(t - delay) + bias (+ drift t).
struct Comparison {
  std::string what;  ///< "speed over ground", "x"
  std::size_t blocks = 0;
  std::optional<Estimate> scale;      ///< 1 is right; empty: the reference hardly changed
  std::optional<Estimate> angle_rad;  ///< a DVL's, about its z axis: VelocityComparison
  std::optional<Estimate> delay_s;    ///< behind the reference, by both drivers' valid_at
  Estimate bias;                      ///< where the scale is known, at zero; else at what there was
  std::optional<Estimate> drift;      ///< a second, where it was asked for
  double residual = 0;                ///< rms of block means
};

/// Least squares over means of common blocks of time. The reference's own noise, told from its
/// motion by second differences, is taken out of the normal equations (W. A. Fuller, Measurement
/// Error Models, 1987, section 1.2), and serial correlation of what is left widens the bounds.
/// Empty: fewer than ten blocks in common.
std::optional<Comparison> compare(const Signal& sensor, const Signal& reference,
                                  bool with_drift = false);

}  // namespace drydock::characterize
