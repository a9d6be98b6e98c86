#pragma once

#include <optional>

#include "drivers/host/follower.hpp"
#include "estimators/frame/geodetic.hpp"
#include "hil/motion/truth.hpp"

namespace drydock::bench {

/// Tells the other followers the truth at the time of an estimate, before they hear the estimate,
/// at most once in 40 ms. Add it before the followers that need the truth.
class TruthTeller final : public host::Follower {
 public:
  /// Both must outlive the teller.
  TruthTeller(const motion::Trajectory& truth, host::Follower& to) : truth_(truth), to_(to) {}

  void on_estimate(const host::Estimate& estimate) override;

 private:
  const motion::Trajectory& truth_;
  host::Follower& to_;
  measurement::Stamp last_{};
  std::optional<frame::Position> origin_;
};

}  // namespace drydock::bench
