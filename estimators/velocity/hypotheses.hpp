#pragma once

#include "estimators/navigation/error_filter.hpp"

namespace drydock::velocity {

/// Two pairs of states that may be absent, that is exactly zero: a current, errors of the log.
/// After what has been measured, four hypotheses (each pair there or not) are weighed by the
/// density ratio of Savage and Dickey, and the filter becomes their mixture: eq. (V8), (V9) of
/// docs/estimators/velocity.md.
struct Weighed {
  navigation::ErrorFilter<7>::Vector errors;  ///< to be fed back
  double absent[2];                           ///< probabilities, first and second pair
};

/// `first`: index of the first of the four states, one after the other; `values`: their estimates;
/// `prior_sigma`: of a pair that is there. The covariance becomes that of the mixture.
Weighed weigh_absence(navigation::ErrorFilter<7>& filter, int first, const Eigen::Vector4d& values,
                      const Eigen::Vector4d& prior_sigma);

}  // namespace drydock::velocity
