#pragma once

#include <algorithm>
#include <cmath>

#include "drivers/measurement/units.hpp"
#include "hil/score/errors.hpp"

namespace drydock::score {

/// Collects lengths of errors.
class LengthSum {
 public:
  void add(double length) {
    ++count_;
    square_ += length * length;
    sum_ += length;
    max_ = std::max(max_, length);
  }
  std::uint64_t count() const { return count_; }
  std::optional<Lengths> result() const {
    if (count_ == 0) return {};
    const auto n = static_cast<double>(count_);
    return Lengths{std::sqrt(square_ / n), sum_ / n, max_};
  }

 private:
  std::uint64_t count_ = 0;
  double square_ = 0, sum_ = 0, max_ = 0;
};

inline double angle_deg(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  return a.angularDistance(b) * units::degrees_per_radian;
}

inline bool has_attitudes(const Pair& pair) {
  return pair.estimate.body_to_ned && pair.truth.body_to_ned;
}

}  // namespace drydock::score
