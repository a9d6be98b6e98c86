#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "drivers/capture/sentence_front.hpp"
#include "drivers/capture/stamp_clock.hpp"
#include "drivers/wire/codec.hpp"

namespace drydock::capture {

/// Removes what a logger wrote in front of the sentences of NMEA 0183 and behind them: its time,
/// the port, quotation marks, as in `2023-12-31T23:59:30.120Z $GPHDT,75.5664,T*36`, and its lines
/// that are a time alone, as front_of_sentences() tells it. A TAG block stays. The times of all are
/// read. Lines that the computer sent (Docklight's [TX]) are left out. The same for the text lines
/// of a DVL (Water Linked, PD6, JSON), if what stands in front is a time. Feed the blocks of the
/// capture in order.
class SentenceStamps {
 public:
  /// The end of a line in what without() returned, and its time.
  struct Timed {
    std::size_t through = 0;
    std::chrono::nanoseconds time{};  ///< as StampClock tells it
  };

  /// The part of the block that a sensor said. Valid until the next call.
  wire::Bytes without(wire::Bytes block);
  /// The begin of a last line that was cut. Valid until the next call.
  wire::Bytes finish();
  std::optional<SentenceFront> front() const { return front_; }  ///< empty: not known yet
  /// The lines of the last block that have a time, or had one in front of them.
  const std::vector<Timed>& times() const { return times_; }
  std::uint64_t lines() const { return lines_; }      ///< that had a stamp, or were one
  std::uint64_t sent_lines() const { return sent_; }  ///< left out
  TextLine kind() const { return kind_; }             ///< of these lines
  const StampClock& clock() const { return clock_; }

 private:
  void decide(wire::Bytes block);
  void take(std::uint8_t byte);
  void take_in_front(std::uint8_t byte);
  void begin_sentence(std::size_t begin);
  void end_line();
  bool is_time_line() const;

  std::optional<SentenceFront> front_;  ///< the first block with some lines decides it
  TextLine kind_ = TextLine::sentence;
  std::vector<std::uint8_t> bytes_, before_;
  std::vector<Timed> times_;
  StampClock clock_;
  bool in_sentence_ = false, in_sent_ = false;  ///< the present line
  unsigned behind_star_ = 0;
  std::uint64_t lines_ = 0, sent_ = 0;
};

}  // namespace drydock::capture
