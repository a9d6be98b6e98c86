#pragma once

#include <algorithm>
#include <cmath>

#include "drivers/measurement/stamp.hpp"

namespace drydock::diagnosis {

using measurement::Stamp;

/// Page's sequential test (Biometrika 41, 1954) on samples that have an event or none: has the
/// share of samples with an event risen from `usual` to `raised`? The sum of the log-likelihood
/// ratios never falls below zero; the test fires at the threshold. A threshold h gives healthy
/// samples at least exp(h) samples to a false alarm (Lorden, Ann. Math. Statist. 42, 1971).
class EventTest {
 public:
  constexpr EventTest(double usual, double raised, double threshold)
      : gain_(std::log(raised / usual)),
        loss_(std::log((1 - usual) / (1 - raised))),
        threshold_(threshold) {}

  void add(bool event, Stamp at) {
    if (!event && sum_ <= 0) return;
    if (event && sum_ <= 0) since_ = at;
    sum_ = std::clamp(sum_ + (event ? gain_ : -loss_), 0.0, threshold_ + gain_);
  }
  void reset() { sum_ = 0; }

  bool fired() const { return sum_ >= threshold_; }
  double sum() const { return sum_; }
  Stamp since() const { return since_; }  ///< the first event of those that made it fire

 private:
  double gain_, loss_, threshold_;
  double sum_ = 0;
  Stamp since_{};
};

}  // namespace drydock::diagnosis
