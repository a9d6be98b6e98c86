#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "hil/motion/ordered/takes_orders.hpp"
#include "hil/motion/steered/steered_trajectory.hpp"

namespace drydock::motion {

/// A motion that keeps its last result, because several sensors may sample at the same instant.
class RememberedTrajectory final : public Trajectory, public TakesOrders {
 public:
  explicit RememberedTrajectory(std::unique_ptr<Trajectory> motion) : motion_(std::move(motion)) {}

  Truth at(Stamp time) const override {
    const std::lock_guard lock(mutex_);
    if (!last_ || last_->at != time) last_ = motion_->at(time);
    return *last_;
  }
  Stamp start() const override { return motion_->start(); }
  Stamp end() const override { return motion_->end(); }
  const ocean::Ocean& ocean() const override { return motion_->ocean(); }
  OrderSink* orders() const override { return orders_of(*motion_); }
  /// Null: no other program steers the motion.
  SteeredTrajectory* steered() const { return motion::steered(*motion_); }

 private:
  std::unique_ptr<Trajectory> motion_;
  mutable std::mutex mutex_;
  mutable std::optional<Truth> last_;
};

/// The motion that another program steers, behind one that remembers. Null: there is none.
inline SteeredTrajectory* steered_behind(const Trajectory& motion) {
  const auto* remembered = dynamic_cast<const RememberedTrajectory*>(&motion);
  return remembered != nullptr ? remembered->steered() : nullptr;
}

}  // namespace drydock::motion
