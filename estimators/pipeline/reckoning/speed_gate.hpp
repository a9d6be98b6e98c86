#pragma once

#include <Eigen/Core>
#include <array>

#include "estimators/pipeline/reckoning/leap_gate.hpp"

namespace drydock::pipeline {

/// The leap gates of a device that tells a velocity in body axes.
class SpeedGate {
 public:
  /// The worst of the three axes.
  LeapGate::Verdict judge(measurement::Stamp at, const Eigen::Vector3d& body_mps) {
    auto worst = LeapGate::Verdict::good;
    for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
      const auto verdict = axes_[axis].judge(at, body_mps(static_cast<Eigen::Index>(axis)));
      if (verdict == LeapGate::Verdict::wild || worst == LeapGate::Verdict::good) worst = verdict;
    }
    if (worst == LeapGate::Verdict::stepped) stepped_at_ = at;
    return worst;
  }

  /// How much may be wrong of a speed, m/s: horizontal steps that no vehicle makes, for 5 min.
  double doubted_mps(measurement::Stamp now) const {
    const bool fresh = now - stepped_at_ <= std::chrono::minutes{5};
    return fresh ? std::hypot(axes_[0].stepped(), axes_[1].stepped()) : 0;
  }

 private:
  /// The thrust of an underwater vehicle is a tenth of its weight or less: 1 m/s2.
  static constexpr LeapLimits limits{.change_per_s = 1, .least = 0.1};
  std::array<LeapGate, 3> axes_{LeapGate(limits), LeapGate(limits), LeapGate(limits)};
  measurement::Stamp stepped_at_{};
};

}  // namespace drydock::pipeline
