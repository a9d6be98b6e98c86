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
  void add(const std::optional<double>& length) {
    if (length) add(*length);
  }
  std::uint64_t count() const { return count_; }
  std::optional<Lengths> result() const {
    if (count_ == 0) return {};
    const auto n = static_cast<double>(count_);
    return Lengths{std::sqrt(square_ / n), sum_ / n, max_};
  }
  std::optional<double> rms() const {
    const auto all = result();
    return all ? std::optional(all->rms) : std::nullopt;
  }

 private:
  std::uint64_t count_ = 0;
  double square_ = 0, sum_ = 0, max_ = 0;
};

/// Of the numbers that are told; empty: none is.
inline std::optional<double> told_length(const Eigen::Vector3d& error) {
  const auto is_told = !error.array().isNaN();
  if (!is_told.any()) return {};
  return is_told.select(error, 0).matrix().norm();
}

inline double angle_deg(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  return a.angularDistance(b) * units::degrees_per_radian;
}

}  // namespace drydock::score
