#pragma once

#include <memory>
#include <utility>

#include "hil/fault/schedule/schedule.hpp"

namespace drydock::fault {

/// Detects the changes of a schedule, by time or by hand.
class ScheduleFollower {
 public:
  ScheduleFollower(std::shared_ptr<const Schedule> schedule, Stamp start)
      : schedule_(std::move(schedule)), followed_(start - std::chrono::nanoseconds{1}) {}

  std::optional<Stamp> deadline() const {
    return edited() ? std::optional(followed_) : next_change_;
  }

  /// The faults in force if they may have changed since the last call; else empty. The pointers are
  /// valid until the schedule is edited.
  std::optional<std::vector<InForce>> changed(Stamp now) {
    const auto due = deadline();
    if (!due || *due > now) return {};
    edits_ = schedule_->edits();
    followed_ = now;
    next_change_ = schedule_->next_change(now);
    return schedule_->in_force(now);
  }

 private:
  bool edited() const { return edits_ != schedule_->edits(); }

  std::shared_ptr<const Schedule> schedule_;
  Stamp followed_{};
  std::optional<Stamp> next_change_;
  std::optional<std::uint64_t> edits_;  ///< empty: not asked yet, so a fault may be in force
                                        ///< already
};

}  // namespace drydock::fault
