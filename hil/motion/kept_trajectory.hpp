#pragma once

#include <memory>
#include <mutex>
#include <unordered_map>

#include "hil/motion/truth.hpp"

namespace drydock::motion {

/// A motion that keeps its results, for many runs that sample it at the same times. It keeps as
/// many as some minutes of a rig ask for, and computes the others each time.
class KeptTrajectory final : public Trajectory {
 public:
  static constexpr std::size_t most_kept = 100'000;

  /// The motion must not take orders: its results would depend on the run.
  explicit KeptTrajectory(std::unique_ptr<Trajectory> motion) : motion_(std::move(motion)) {}

  Truth at(Stamp time) const override {
    const std::lock_guard lock(mutex_);
    const auto known = kept_.find(time.time_since_epoch().count());
    if (known != kept_.end()) return known->second;
    Truth truth = motion_->at(time);
    if (kept_.size() < most_kept) kept_.emplace(time.time_since_epoch().count(), truth);
    return truth;
  }
  Stamp start() const override { return motion_->start(); }
  Stamp end() const override { return motion_->end(); }
  const ocean::Ocean& ocean() const override { return motion_->ocean(); }

 private:
  std::unique_ptr<Trajectory> motion_;
  mutable std::mutex mutex_;
  mutable std::unordered_map<std::int64_t, Truth> kept_;
};

}  // namespace drydock::motion
