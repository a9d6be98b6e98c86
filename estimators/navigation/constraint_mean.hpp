#pragma once

#include <cmath>

namespace drydock::navigation {

/// Mean of the normalised innovations of a constraint over about `span_s`, with the latest counted
/// most: eq. (I7) of docs/estimators/integrity.md. statistic() is standard normal if they are
/// white.
class ConstraintMean {
 public:
  explicit ConstraintMean(double span_s) : span_s_(span_s) {}

  void add(double normalised, double dt_s) {
    const double share = 1 - std::exp(-dt_s / span_s_), kept = 1 - share;
    mean_ = kept * mean_ + share * normalised;
    variance_ = kept * kept * variance_ + share * share;
  }
  void clear() { mean_ = variance_ = 0; }
  double statistic() const { return variance_ > 0 ? mean_ / std::sqrt(variance_) : 0; }

 private:
  double span_s_, mean_ = 0, variance_ = 0;
};

}  // namespace drydock::navigation
