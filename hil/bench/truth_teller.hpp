#pragma once

#include <optional>

#include "drivers/host/follower.hpp"
#include "estimators/frame/geodetic.hpp"
#include "hil/motion/truth.hpp"

namespace drydock::bench {

/// Tells the other followers the truth at the time of an estimate, before they hear the estimate,
/// at most once in 40 ms and never one that is older than another; and between estimates every 40
/// to 60 ms, whether they come or not. Add it before the followers that need the truth.
class TruthTeller final : public host::Follower {
 public:
  /// Truth and follower must outlive the teller. `wait`: how late an estimate may come after its
  /// time, until then a silence may yet end; 0 without estimators.
  TruthTeller(const motion::Trajectory& truth, host::Follower& to, Stamp start,
              std::chrono::nanoseconds wait)
      : truth_(truth), to_(to), newest_(start), wait_(wait) {}

  void on_estimate(const host::Estimate& estimate) override;
  void tick(Stamp now) override { fill(now - wait_); }
  /// The truth up to the end of a run.
  void finish(Stamp end) { fill(end); }

 private:
  void fill(Stamp end);
  void tell(Stamp at);

  const motion::Trajectory& truth_;
  host::Follower& to_;
  Stamp last_{}, newest_;  ///< of an estimate; of all
  std::chrono::nanoseconds wait_;
  std::optional<frame::Position> origin_;
};

}  // namespace drydock::bench
