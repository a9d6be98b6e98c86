#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "drivers/capture/sentence_stamps.hpp"

namespace drydock::capture {

/// The bytes of a log whose lines have a time and pairs of hexadecimal digits behind it, as
/// Docklight writes them: `01.05.2024 12:00:00.12 [RX] - 24 47 50`. What the computer sent ([TX])
/// is left out. Feed the blocks in order.
class StampedHex {
 public:
  /// True if nearly all lines of the text are such.
  static bool recognises(wire::Bytes text);

  /// Valid until the next call.
  wire::Bytes of(wire::Bytes block);
  wire::Bytes finish();  ///< of a last line without an end
  std::span<const SentenceStamps::Timed> times() const { return times_; }
  const StampClock& clock() const { return clock_; }
  std::uint64_t lines() const { return lines_; }
  std::uint64_t sent_lines() const { return sent_; }
  std::uint64_t odd_lines() const { return odd_; }

 private:
  void take_line();

  std::vector<std::uint8_t> line_, bytes_;
  std::vector<SentenceStamps::Timed> times_;
  StampClock clock_;
  std::uint64_t lines_ = 0, sent_ = 0, odd_ = 0;
};

}  // namespace drydock::capture
