#pragma once

/// The noise of a sensor at rest as sums of independent processes, IEEE Std 952, annex C, in units
/// of the quantity q. docs/sensors/characterize.md numbers the equations.
namespace drydock::characterize {

struct NoiseModel {
  double quantisation =
      0;  ///< Q: of the integral, q s; a carried step q at interval dt gives Q = q dt / sqrt(12)
  double density = 0;        ///< N: white, q/sqrt(Hz)
  double instability = 0;    ///< B: first-order Gauss-Markov process, 1 sigma, q
  double correlation_s = 0;  ///< T: of that process
  double walk = 0;           ///< K: random walk of the reading, q/sqrt(s)

  /// Allan variance at the cluster time tau, (1).
  double allan_variance(double tau_s) const;
};

/// Allan variance of a Gauss-Markov process of variance 1, T > 0.
double allan_of_gauss_markov(double tau_s, double correlation_s);

}  // namespace drydock::characterize
