#pragma once

#include <algorithm>
#include <chrono>

#include "drivers/measurement/stamp.hpp"

namespace drydock::link {

/// Puts a CAN controller's stamps on the host's clock. The controller counts from an epoch of its
/// own, and not quite as fast. A frame's software stamp is later than the frame by the time that
/// the bus adapter and the kernel need, so the smallest difference of the two stamps in the last
/// one to two seconds is the offset. At 100 ppm between the clocks it is wrong by at most 0.2 ms.
class ControllerClock {
 public:
  using Stamp = measurement::Stamp;
  using Duration = std::chrono::nanoseconds;

  /// The time of a frame with these two stamps; never later than `by_kernel`.
  Stamp on_host(Duration by_controller, Stamp by_kernel) {
    const Duration offset = by_kernel.time_since_epoch() - by_controller;
    const bool jumped = known_ && (offset > smallest() + jump || offset < smallest() - jump);
    if (!known_ || jumped) start(offset, by_controller);
    if (by_controller - since_ >= window) {
      before_ = now_;
      now_ = offset;
      since_ = by_controller;
    }
    now_ = std::min(now_, offset);
    return Stamp{by_controller + smallest()};
  }

 private:
  static constexpr Duration window = std::chrono::seconds{1};
  /// A clock was set, or the adapter has started anew: no kernel stamps a frame so late.
  static constexpr Duration jump = std::chrono::milliseconds{100};

  Duration smallest() const { return std::min(now_, before_); }
  void start(Duration offset, Duration at) {
    known_ = true;
    now_ = before_ = offset;
    since_ = at;
  }

  bool known_ = false;
  Duration now_{}, before_{};  ///< smallest offset of this window and of the one before
  Duration since_{};           ///< start of this window, on the controller's clock
};

}  // namespace drydock::link
