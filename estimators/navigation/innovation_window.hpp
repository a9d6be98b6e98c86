#pragma once

#include <array>
#include <cstdint>

namespace drydock::navigation {

/// Upper tail of chi-square: the probability that the sum of the squares of `pairs` times two
/// standard normal values is above `x`. Closed form of an even number of degrees of freedom.
double chi_square_tail(double x, int pairs);

/// The value that this tail exceeds with `probability`.
double chi_square_limit(double probability, int pairs);

/// Judges the last innovations of one row of a sensor: eq. (I5), (I6) of
/// docs/estimators/integrity.md. They contradict the filter if their squares or their mean are too
/// large for its covariance, or if too many of them are outliers. Allocates nothing.
class InnovationWindow {
 public:
  static constexpr int size = 10;  ///< even, for the closed form
  /// Probability of a false alarm of each of the two sums, for one new innovation.
  static constexpr double false_alarm = 1e-7;

  /// An innovation beyond this many standard deviations is one of an outlier: it counts as such,
  /// and not in the sums.
  static constexpr double outlier_sigmas = 6;
  static constexpr int most_outliers = 4;  ///< of the last `size`

  /// An innovation over its standard deviation, used or not.
  void add(double normalised);
  void clear() { *this = {}; }

  /// Sum of the squares of the last `size` that are no outliers; chi-square once they are there.
  double squares() const;
  /// Their sum over the root of their number; standard normal.
  double mean() const;
  int outliers() const;  ///< of the last `size`
  bool contradicts() const;

 private:
  std::array<double, size> values_{};
  std::uint32_t count_ = 0;     ///< values so far; the ring's place is count_ % size
  std::uint32_t outliers_ = 0;  ///< bit 0: the newest
};

}  // namespace drydock::navigation
