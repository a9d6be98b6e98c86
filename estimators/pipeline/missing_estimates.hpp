#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>

#include "estimators/pipeline/estimator.hpp"

namespace drydock::pipeline {

/// Counts the estimates that did not come: where the last one is too old, as many as its pace
/// before would have given.
class MissingEstimates {
 public:
  explicit MissingEstimates(std::chrono::nanoseconds oldest) : oldest_(oldest) {}

  /// Call it whenever the estimator may have given one.
  void note(const EstimatorStatus& status) {
    if (status.estimates == seen_) return;
    if (seen_ > 0) {
      counted_ += missing_until(status.last_estimate, status);
      const auto took = (status.last_estimate - last_) / (status.estimates - seen_);
      if (took > took.zero() && !too_old(status.last_estimate, status)) pace_ = took;
    }
    seen_ = status.estimates;
    last_ = status.last_estimate;
  }

  /// All of them until `now`.
  std::uint64_t count(measurement::Stamp now, const EstimatorStatus& status) const {
    return counted_ + missing_until(now, status);
  }

 private:
  bool too_old(measurement::Stamp now, const EstimatorStatus& status) const {
    return seen_ > 0 && now - last_ > std::max(oldest_, status.longest_silence);
  }
  std::uint64_t missing_until(measurement::Stamp now, const EstimatorStatus& status) const {
    if (!too_old(now, status) || pace_ <= pace_.zero()) return 0;
    const auto due = (now - last_) / pace_;
    return due > 1 ? static_cast<std::uint64_t>(due - 1) : 0;
  }

  std::chrono::nanoseconds oldest_, pace_{0};
  std::uint64_t seen_ = 0, counted_ = 0;
  measurement::Stamp last_{};
};

}  // namespace drydock::pipeline
