#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "drivers/measurement/stamp.hpp"
#include "drivers/monitor/screen/shown_frame.hpp"
#include "drivers/wire/codec.hpp"

namespace drydock::monitor {

/// The last frame of one kind, and how often that kind comes. Allocates only for a frame that is
/// longer than all before it.
class KeptFrame {
 public:
  void take(wire::Bytes frame, measurement::Stamp at) {
    if (count_ > 0) {
      const double interval_s = measurement::seconds(at - last_at_);
      mean_interval_s_ += (interval_s - mean_interval_s_) /
                          static_cast<double>(std::min<std::uint64_t>(count_, 16));
    }
    bytes_.assign(frame.begin(), frame.end());
    last_at_ = at;
    ++count_;
  }
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

  /// Bytes that differ from those of the call before are marked; there are none at the first call.
  ShownFrame show(std::string name) {
    ShownFrame shown{.name = std::move(name), .count = count_, .bytes = bytes_};
    if (mean_interval_s_ > 0) shown.rate_hz = 1 / mean_interval_s_;
    for (std::size_t i = 0; i < bytes_.size(); ++i)
      shown.changed.push_back(seen_ && (i >= shown_bytes_.size() || bytes_[i] != shown_bytes_[i]));
    shown_bytes_ = bytes_;
    seen_ = true;
    return shown;
  }

 private:
  std::vector<std::uint8_t> bytes_, shown_bytes_;
  measurement::Stamp last_at_{};
  double mean_interval_s_ = 0;
  std::uint64_t count_ = 0;
  bool seen_ = false;
};

}  // namespace drydock::monitor
