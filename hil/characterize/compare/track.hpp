#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "hil/characterize/samples.hpp"

namespace drydock::characterize {

/// Values over seconds since `zero`, with linear interpolation.
class Track {
 public:
  Track() = default;
  /// Missing values (NaN) are left out.
  Track(const Samples& samples, const std::vector<Eigen::Vector3d>& values,
        measurement::Stamp zero);

  /// Empty outside the track, or in a gap of more than 1.5 periods.
  std::optional<Eigen::Vector3d> at(double t_s) const;

  bool empty() const { return t_s_.size() < 2; }
  double period_s() const { return period_s_; }  ///< median
  const std::vector<double>& times() const { return t_s_; }
  const std::vector<Eigen::Vector3d>& values() const { return values_; }

 private:
  std::vector<double> t_s_;
  double period_s_ = 0;
  std::vector<Eigen::Vector3d> values_;
};

}  // namespace drydock::characterize
