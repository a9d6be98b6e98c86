#pragma once

#include "drivers/host/follower.hpp"
#include "hil/motion/truth.hpp"
#include "hil/summary/error_sum.hpp"
#include "hil/summary/summary.hpp"

namespace drydock::summary {

/// Error of one estimator's roll and pitch. Input in radians, result in degrees.
class ErrorStatistics {
 public:
  /// Both angles within this: the estimate has settled. Chosen: what a vehicle's autopilot and a
  /// DVL's levelling hardly notice.
  static constexpr double settled_deg = 1;

  /// `t_s`: time of the estimate since the start of the run.
  void add(const bus::Attitude& estimate, const motion::Truth& truth, double t_s);
  std::uint64_t count() const { return roll_.count(); }
  AttitudeError result() const;

 private:
  ErrorSum roll_, pitch_, nees_;
  double wide_s_ = 0;     ///< the last time outside settled_deg
  bool settled_ = false;  ///< the last estimate
};

}  // namespace drydock::summary
