#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::diagnosis {

using measurement::Stamp;

/// Counts whole frames of a line against its own first time. Where a driver recognises a repeated
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
    second_at_ = now;
    std::rotate(counts_.begin(), counts_.begin() + 1, counts_.end());
    counts_.back() = frames;
    ++seconds_;
    const auto in_window = static_cast<double>(counts_.back() - counts_.front());
    if (seconds_ <= window) return {};
    if (now - *first_ < learning) most_ = std::max(most_, in_window);
    if (now - *first_ < learning) return {};
    const double excess = in_window - most_;
    if (excess < std::max(least_frames, least_share * most_)) return {};
    return excess;
  }

  double usual() const { return most_; }

 private:
  void start(std::uint64_t frames, Stamp now) {
    first_ = second_at_ = now;
    counts_.fill(frames);
  }

  std::optional<Stamp> first_;
  Stamp second_at_{};
  std::array<std::uint64_t, window + 1> counts_{};
  std::size_t seconds_ = 0;
  double most_ = 0;  ///< frames in a window of the first time
};

}  // namespace drydock::diagnosis
