#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "estimators/leveling/leveling_options.hpp"
#include "estimators/navigation/constraint_mean.hpp"

namespace drydock::pipeline {

/// Judges the innovations of the constraints V_y = 0 and V_z = 0 of a leveling filter over a short
/// and a long time: eq. (I7) of docs/estimators/integrity.md.
class ConstraintWatch {
 public:
  static constexpr double short_s = 2, long_s = 8;
  static constexpr double limit = 5.3267;  ///< of a standard normal value, two-sided 1e-7

  void add(const leveling::ConstraintInnovations& innovations, double dt_s) {
    for (auto& mean : transverse_) mean.add(innovations.transverse, dt_s);
    for (auto& mean : vertical_) mean.add(innovations.vertical, dt_s);
  }
  void clear() { *this = {}; }

  bool contradict() const {
    const auto beyond = [](const navigation::ConstraintMean& mean) {
      return !(std::abs(mean.statistic()) <= limit);  // true for NaN too
    };
    return std::ranges::any_of(transverse_, beyond) || std::ranges::any_of(vertical_, beyond);
  }

 private:
  using Means = std::array<navigation::ConstraintMean, 2>;
  Means transverse_{navigation::ConstraintMean(short_s), navigation::ConstraintMean(long_s)};
  Means vertical_ = transverse_;
};

}  // namespace drydock::pipeline
