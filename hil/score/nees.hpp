#pragma once

#include "hil/score/errors.hpp"

namespace drydock::score {

/// Collects errors with their covariances, of the numbers whose error and variance are told.
class NeesSum {
 public:
  void add(const Eigen::Vector3d& error, const std::optional<Eigen::Matrix3d>& covariance);
  Nees result() const;

 private:
  std::uint64_t covariances_ = 0, pairs_ = 0;
  double sum_ = 0;
};

}  // namespace drydock::score
