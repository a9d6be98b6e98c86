#pragma once

#include <Eigen/Core>
#include <optional>

#include "drivers/measurement/measurement.hpp"
#include "estimators/frame/geodetic.hpp"

namespace drydock::pipeline {

/// By how much the fixes of a fast vehicle are late, from themselves alone: the way between two
/// positions over the velocity is the time between them, whatever their times of validity say. Eq.
/// (39) of docs/estimators/roll.md. Allocates nothing.
class FixTiming {
 public:
  /// Fixes in order of valid_at. One without position or height says nothing.
  void add(const measurement::GnssFix& fix, const Eigen::Vector3d& velocity_ned);
  void clear() { *this = {}; }

  double late_s() const { return late_s_; }  ///< more than at the first fix
  /// Square of the lateness beyond that which the noise of the positions explains, s2.
  double variance() const;

 private:
  struct Place {
    measurement::Stamp at;
    frame::Position position;
    Eigen::Vector3d velocity_ned;
  };
  std::optional<Place> last_;
  double late_s_ = 0;
  double noise_s_ = 0;  ///< one sigma of late_s_
};

}  // namespace drydock::pipeline
