#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "drivers/capture/logger_date.hpp"
#include "drivers/capture/steady_times.hpp"
#include "drivers/capture/text_line.hpp"
#include "drivers/wire/codec.hpp"
#include "drivers/wire/day_clock.hpp"

namespace drydock::capture {

/// What stands in front of the sentences of a text.
enum class SentenceFront : std::uint8_t { nothing, stamp, tag_block };

/// What nearly all whole lines of the text have in front of a sentence of NMEA 0183 with a right
/// checksum. Empty: too few lines to tell.
std::optional<SentenceFront> front_of_sentences(wire::Bytes text);

/// Removes what a logger wrote in front of the sentences of NMEA 0183 and behind them: its time,
/// the port, quotation marks, as in `2023-12-31T23:59:30.120Z $GPHDT,75.5664,T*36`. Only where
/// nearly every line of the file's begin is such a one. A TAG block stays. The times of both are
/// read. The same for the text lines of a DVL (Water Linked, PD6, JSON), if what stands in front
/// is a time. Feed the blocks of the capture in order.
class SentenceStamps {
 public:
  /// The end of a line in what without() returned, and its time.
  struct Timed {
    std::size_t through = 0;
    std::chrono::nanoseconds time{};  ///< since 1970, or since the midnight before the first line
  };

  /// The part of the block that a sensor said. Valid until the next call.
  wire::Bytes without(wire::Bytes block);
  /// The begin of a last line that was cut. Valid until the next call.
  wire::Bytes finish();
  std::optional<SentenceFront> front() const { return front_; }  ///< empty: not known yet
  /// The lines of the last block that have a time, or had one in front of them.
  const std::vector<Timed>& times() const { return times_; }
  std::uint64_t lines() const { return lines_; }         ///< that had a stamp
  TextLine kind() const { return kind_; }                ///< of these lines
  std::uint64_t timed_lines() const { return timed_; }   ///< whose stamp or TAG block had a time
  bool whole_seconds() const { return whole_seconds_; }  ///< no time had a fraction
  /// True if the times are of day: no date stands beside the first one.
  bool without_date() const { return dated_ == false; }
  const SteadyTimes& clock() const { return steady_; }

 private:
  void decide(wire::Bytes block);
  void take(std::uint8_t byte);
  void begin_sentence(std::size_t begin);
  void end_line();
  void read_time();

  std::optional<SentenceFront> front_;  ///< the first block with some lines decides it
  TextLine kind_ = TextLine::sentence;
  std::vector<std::uint8_t> bytes_, before_;
  std::vector<Timed> times_;
  std::optional<std::chrono::nanoseconds> last_;  ///< time of the present line, or one before
  std::optional<bool> dated_;                     ///< the first time decides it
  DateOrder order_ = DateOrder::unknown;
  wire::DayClock days_;
  SteadyTimes steady_;
  bool whole_seconds_ = true;
  std::uint64_t timed_ = 0;
  bool in_sentence_ = false;  ///< the present line
  unsigned behind_star_ = 0;
  std::uint64_t lines_ = 0;
};

}  // namespace drydock::capture
