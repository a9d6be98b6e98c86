#pragma once

#include <optional>

#include "drivers/host/follower.hpp"
#include "estimators/frame/geodetic.hpp"
#include "hil/motion/truth.hpp"
#include "hil/summary/error_sum.hpp"
#include "hil/summary/summary.hpp"

namespace drydock::summary {

/// Follows one navigation estimator: its error against the truth, and curves with fewer points.
class NavigationRecord {
 public:
  /// `truth` is the truth at the estimate's valid_at, or null. `draw`: add a point to the curves.
  void note(const bus::Navigation& estimate, const std::optional<host::Current>& current,
            const motion::Truth* truth, double t_s, bool draw);

  std::optional<NavigationError> error() const;  ///< empty: no estimate had a truth
  const NavigationTrace& trace() const { return trace_; }

 private:
  void compare(const bus::Navigation& estimate, const motion::Truth& truth, bool draw);

  std::optional<frame::Position> origin_;
  NavigationTrace trace_;
  std::uint64_t count_ = 0;
  ErrorSum horizontal_, down_, speed_, roll_, pitch_, heading_, nees_;
  double horizontal_last_ = 0;
};

}  // namespace drydock::summary
