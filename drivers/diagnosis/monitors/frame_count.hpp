#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::diagnosis {

using measurement::Stamp;

/// Counts whole frames of a line against its own first time. What was held before is not too many.
/// Where a driver recognises a repeated
/// message and drops it, only this count shows that it came.
class FrameCount {
 public:
  static constexpr std::chrono::seconds learning{40};
  static constexpr std::size_t window = 8;  ///< seconds
  /// Frames more than usual in a window: a sound line has at most the answers to a host.
  static constexpr double least_share = 0.06, least_frames = 4;

  /// How many frames too many came in the last window, if it is more than a sound line gives.
  std::optional<double> add(std::uint64_t frames, Stamp now) {
    if (!first_) start(frames, now);
    if (now - second_at_ < std::chrono::seconds{1}) return {};
    if (now - second_at_ > longest_step) begin_window(frames);
    second_at_ = now;
    std::rotate(counts_.begin(), counts_.begin() + 1, counts_.end());
    counts_.back() = frames;
    ++seconds_;
    const auto in_window = static_cast<double>(counts_.back() - counts_.front());
    if (seconds_ <= window) return {};
    if (now - *first_ < learning) {
      most_ = std::max(most_, in_window);
      least_ = least_ > 0 ? std::min(least_, in_window) : in_window;
      return {};
    }
    const auto in_second = static_cast<double>(counts_.back() - *(counts_.end() - 2));
    std::rotate(held_.begin(), held_.begin() + 1, held_.end());
    held_.back() = std::clamp(*(held_.end() - 2) + least_ / window - in_second, 0.0, most_);
    const double excess = in_window - most_ - held_.front();
    if (excess < most_excess()) return {};
    return excess;
  }

  /// So many frames too many in a window are none of a fault.
  double most_excess() const { return std::max(least_frames, least_share * most_); }

 private:
  void start(std::uint64_t frames, Stamp now) {
    first_ = second_at_ = now;
    begin_window(frames);
  }
  void begin_window(std::uint64_t frames) {
    counts_.fill(frames);
    held_.fill(0);
    seconds_ = 0;
  }
  /// Where nobody looked for longer, the counts of a second are not known.
  static constexpr std::chrono::milliseconds longest_step{2500};

  std::optional<Stamp> first_;
  Stamp second_at_{};
  std::array<std::uint64_t, window + 1> counts_{};
  std::size_t seconds_ = 0;
  double most_ = 0, least_ = 0;            ///< frames in a window of the first time
  std::array<double, window + 1> held_{};  ///< that did not come yet, at each of counts_
};

}  // namespace drydock::diagnosis
