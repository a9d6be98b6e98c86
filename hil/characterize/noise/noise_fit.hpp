#pragma once

#include <optional>

#include "hil/characterize/estimate.hpp"
#include "hil/characterize/noise/allan_curve.hpp"

namespace drydock::characterize {

/// Which processes a fit may use. White noise always.
struct NoiseTerms {
  bool quantisation = true, instability = true, walk = true;
};

/// The processes that an Allan curve shows. An empty one is not needed to explain it.
struct NoiseFit {
  NoiseModel model;
  std::optional<Estimate> quantisation, density, instability, correlation_s, walk;
  std::vector<Estimate> deviation;  ///< of the curve, by its points
};

/// Likeliest non-negative sum of the terms: each variance is chi-square distributed about the
/// model's with the degrees of freedom of covariance(), which makes it weighted least squares of
/// the curve's relative error, weights found by iteration. A term has to earn its place. Bounds
/// from the covariance of all points together. Empty: fewer than four points, or all readings
/// equal.
std::optional<NoiseFit> fit_noise(const AllanCurve& curve, const NoiseTerms& terms = {});

}  // namespace drydock::characterize
