#pragma once

#include <optional>

#include "hil/characterize/estimate.hpp"
#include "hil/characterize/noise/allan_curve.hpp"

namespace drydock::characterize {

/// The processes that a fit may use. White noise is always used.
struct NoiseTerms {
  bool quantisation = true, instability = true, walk = true;
};

/// The processes that an Allan curve shows. An empty process is not needed to explain the curve.
struct NoiseFit {
  NoiseModel model;
  std::optional<Estimate> quantisation, density, instability, correlation_s, walk;
  std::vector<Estimate> deviation;  ///< one per point of the curve
};

/// The most likely non-negative sum of the terms. Each variance has a chi-square distribution about
/// the model's, with the degrees of freedom of covariance(). This is weighted least squares of the
/// curve's relative error, with weights found by iteration. A term is used only if it improves the
/// fit enough. Bounds come from the joint covariance of all points. Empty if there are fewer than
/// four points, or all readings are equal.
std::optional<NoiseFit> fit_noise(const AllanCurve& curve, const NoiseTerms& terms = {});

}  // namespace drydock::characterize
