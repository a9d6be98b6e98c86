#include "hil/characterize/noise/noise_model.hpp"

#include <cmath>

namespace drydock::characterize {

double allan_of_gauss_markov(double tau_s, double correlation_s) {
  const double x = tau_s / correlation_s;
  // For small x the brackets cancel to x^2 / 3. Then the next terms of the series are enough.
  if (x < 1e-3) return x / 3 * (1 - 0.75 * x);
  return 2 / x * (1 - (3 - 4 * std::exp(-x) + std::exp(-2 * x)) / (2 * x));
}

double NoiseModel::allan_variance(double tau) const {
  double variance =
      (3 * quantisation * quantisation / tau + density * density) / tau + walk * walk * tau / 3;
  if (instability > 0)
    variance += instability * instability * allan_of_gauss_markov(tau, correlation_s);
  return variance;
}

}  // namespace drydock::characterize
