#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::device {

/// Which frame its device sends first of a sample: the one behind the longest pause. So a sample
/// that lost its first frame is not begun by its second one and ended by the next sample's first.
/// A late read makes a wrong vote, so the most votes count. Frames are told apart by a number below
/// 64 of the caller's choice.
class SampleOrder {
 public:
  /// A frame of a sample came.
  void hear(unsigned frame, measurement::Stamp at);
  /// Forgets the last frame, not what it learned.
  void interrupt() { last_at_.reset(); }

  /// Empty until it is clear, and where the pauses are too alike to tell.
  std::optional<unsigned> first() const { return first_; }

 private:
  void judge_pauses();
  void vote(unsigned frame);

  std::optional<measurement::Stamp> last_at_;
  std::array<measurement::Stamp::duration, 64> pause_{};  ///< before each frame of this round
  std::uint64_t heard_ = 0;                               ///< of this round, each a bit
  std::array<double, 64> votes_{};                        ///< older ones weigh less
  std::optional<unsigned> first_;
};

}  // namespace drydock::device
