#pragma once

#include <memory>
#include <utility>

#include "hil/fault/schedule/schedule.hpp"

namespace drydock::fault {

/// Sees when a schedule comes to a change, by its times or by hand.
class ScheduleFollower {
 public:
  ScheduleFollower(std::shared_ptr<const Schedule> schedule, Stamp start)
      : schedule_(std::move(schedule)), followed_(start - std::chrono::nanoseconds{1}) {}

  std::optional<Stamp> deadline() const {
    return edited() ? std::optional(followed_) : next_change_;
  }

  /// What is in force, where it may be something else than at the last call. What it points to
  /// holds until the schedule is edited.
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
  std::optional<std::uint64_t> edits_;  ///< none: not looked yet, and a fault may hold already
};

}  // namespace drydock::fault
