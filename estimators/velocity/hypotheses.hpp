#pragma once

#include "estimators/navigation/error_filter.hpp"

namespace drydock::velocity {

/// Two pairs of states may be absent, which means exactly zero: the current and the errors of the
/// log. There are four hypotheses: each pair is present or absent. The density ratio of Savage and
/// Dickey weighs them, and the filter becomes their mixture: eq. (V8), (V9) of
/// docs/estimators/velocity.md.
struct Weighed {
  navigation::ErrorFilter<7>::Vector errors;  ///< for feedback by the caller
  double absent[2];                           ///< probabilities, first and second pair
};

/// `first`: index of the first of the four consecutive states; `values`: their estimates;
/// `prior_sigma`: their prior if present. The covariance of the filter becomes that of the mixture.
Weighed weigh_absence(navigation::ErrorFilter<7>& filter, int first, const Eigen::Vector4d& values,
                      const Eigen::Vector4d& prior_sigma);

}  // namespace drydock::velocity
