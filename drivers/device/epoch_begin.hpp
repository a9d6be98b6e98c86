#pragma once

#include <algorithm>
#include <chrono>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::device {

using measurement::Stamp;

/// When the messages of an epoch began. Its first message tells it. Where damage took that one, the
/// next whole message comes later by what the damaged bytes needed on the line. The device's own
/// clock then tells the begin, from the last epoch that came whole. It undoes no more than the
/// damaged bytes explain: noise in front of an epoch, and an epoch that is late, change nothing.
class EpochBegin {
 public:
  /// `first_valid_at` is that of the first whole message, `device_time` the epoch's time by the
  /// device, `damaged` the line time of the bytes that were skipped in front of that message.
  Stamp of(Stamp first_valid_at, std::chrono::nanoseconds device_time,
           std::chrono::nanoseconds damaged) {
    if (damaged.count() == 0) {
      whole_ = Epoch{first_valid_at, device_time};
      return first_valid_at;
    }
    const auto since = whole_ ? device_time - whole_->device_time : none;
    if (since <= none || since > reach) return first_valid_at;
    const auto late = first_valid_at - (whole_->valid_at + since);
    if (late <= none || late > damaged + host_delay) return first_valid_at;
    return first_valid_at - std::min(late, damaged);
  }

  void forget() { whole_.reset(); }

 private:
  struct Epoch {
    Stamp valid_at;
    std::chrono::nanoseconds device_time;
  };

  static constexpr std::chrono::nanoseconds none{0};
  static constexpr std::chrono::seconds reach{10};  ///< clocks that differ by 100 ppm: 1 ms
  static constexpr std::chrono::milliseconds host_delay{5};

  std::optional<Epoch> whole_;
};

}  // namespace drydock::device
