#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/host/follower.hpp"

namespace drydock::host {

/// Statuses of `rt/diagnostics` for what the estimators promise: "leveling/integrity" with the
/// bounds in degrees and metres (docs/estimators/integrity.md), each time an estimate becomes valid
/// or ceases to be, and once a second.
class IntegrityStatuses {
 public:
  /// `estimators`: their names, by `Estimate::estimator`.
  explicit IntegrityStatuses(std::vector<std::string> estimators);

  /// Empty: there is nothing new, or the estimate came without bounds.
  std::optional<bus::DeviceStatus> take(const Estimate& estimate);

  /// An estimator that gives none any more is not valid: calls `tell(status)` for each whose last
  /// estimate is too old, at the change and once a second. Call it with the time of whatever comes.
  template <class Tell>
  void look(measurement::Stamp now, Tell&& tell) {
    now_ = now;
    for (Told& told : told_)
      if (told.is_too_old(now)) tell(outdated(told));
  }

 private:
  struct Told {
    bool is_too_old(measurement::Stamp now) const;

    std::string name;
    measurement::Stamp at{};
    bool valid = false;
    std::optional<measurement::Stamp> estimate{};  ///< valid_at of the last one
    measurement::Stamp came{};                     ///< when it was told
    std::chrono::nanoseconds pace{0};              ///< between the last two
    measurement::Stamp told_old{};                 ///< the last time that it was too old
  };
  bus::DeviceStatus outdated(Told& told) const;

  std::vector<Told> told_;
  measurement::Stamp now_{};
};

}  // namespace drydock::host
