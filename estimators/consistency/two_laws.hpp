#pragma once

#include <cmath>

namespace drydock::consistency {

/// What a law says, and its 1 sigma.
struct Likely {
  double value = 0, sigma = 0;
};

/// Two laws that were equally likely before they were seen to be wrong. A misfit is the sum of the
/// squares of what a law said wrong, in sigmas of a normal error. Returns the probability of the
/// second, by Bayes's rule.
inline double share_of_second(double first_misfit, double second_misfit) {
  return 1 / (1 + std::exp((second_misfit - first_misfit) / 2));
}

/// Mean and standard deviation of what both say.
inline Likely mixed(const Likely& first, const Likely& second, double share) {
  const double value = (1 - share) * first.value + share * second.value;
  const auto square = [](double x) { return x * x; };
  const auto variance = [&](const Likely& one) {
    return square(one.sigma) + square(one.value - value);
  };
  return {value, std::sqrt((1 - share) * variance(first) + share * variance(second))};
}

}  // namespace drydock::consistency
