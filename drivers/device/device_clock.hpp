#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::device {

using measurement::Stamp;

/// Maps the wrapping 32-bit tick counter of a device to the host's clock. Bus and host can only
/// delay a message; it never comes early. Therefore the offset between the clocks is the least that
/// was seen. The offset rises by 100 ppm of the elapsed time, so that it follows crystals that
/// drift apart. A counter that jumps (the device restarted) and goes on from there begins anew.
class DeviceClock {
 public:
  explicit DeviceClock(std::chrono::nanoseconds tick) : tick_(tick) {}

  struct Time {
    std::chrono::nanoseconds device;  ///< since the device's zero, or since the first message
    Stamp host;                       ///< never later than the time by arrival
  };

  /// `by_arrival` is the time at which the value was true according to its frame's arrival.
  Time map(std::uint32_t ticks, Stamp by_arrival) {
    const auto step = static_cast<std::int32_t>(ticks - last_ticks_);  // correct across the wrap
    elapsed_ = offset_ ? elapsed_ + step * tick_ : ticks * tick_;
    last_ticks_ = ticks;
    const auto offset = by_arrival - Stamp{elapsed_};
    if (offset_ && std::chrono::abs(offset - *offset_) > restart_) {
      const bool goes_on = jumped_ && std::chrono::abs(offset - *jumped_) < restart_;
      jumped_ = offset;
      if (!goes_on) return {elapsed_, by_arrival};
      elapsed_ = ticks * tick_;
      offset_.reset();
    }
    jumped_.reset();
    const auto seen = by_arrival - Stamp{elapsed_};
    const auto parted = offset_ ? (by_arrival - last_arrival_) / drift_divisor : seen.zero();
    offset_ = offset_ ? believed(seen, *offset_ + parted) : seen;
    last_arrival_ = by_arrival;
    return {elapsed_, std::min(by_arrival, Stamp{elapsed_} + *offset_)};
  }

  void reset() { offset_.reset(); }

 private:
  /// A tick that seems to come far earlier than all before is damaged, unless the next two agree:
  /// where many bits are flipped, two in a row may be off by the same bit.
  std::chrono::nanoseconds believed(std::chrono::nanoseconds seen, std::chrono::nanoseconds least) {
    const bool early = seen < least - bus_;
    const bool agrees = early && in_row_ > 0 && std::chrono::abs(seen - early_) < bus_;
    in_row_ = agrees ? in_row_ + 1 : early ? 1 : 0;
    early_ = seen;
    return early && in_row_ < enough_in_row_ ? least : std::min(seen, least);
  }

  static constexpr std::chrono::seconds restart_{1};
  static constexpr std::chrono::milliseconds bus_{10};  ///< a bus delays a message by less
  static constexpr int enough_in_row_ = 3;
  static constexpr int drift_divisor = 10'000;

  std::chrono::nanoseconds tick_;
  std::uint32_t last_ticks_ = 0;
  std::chrono::nanoseconds elapsed_{0};
  std::optional<std::chrono::nanoseconds> offset_;
  std::optional<std::chrono::nanoseconds> jumped_;  ///< of the tick before, if it jumped
  std::chrono::nanoseconds early_{0};
  int in_row_ = 0;  ///< ticks that came so early
  Stamp last_arrival_{};
};

}  // namespace drydock::device
