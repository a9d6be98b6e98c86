#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "drivers/wire/codec.hpp"

namespace drydock::capture {

/// Removes what a logger wrote in front of the sentences of NMEA 0183 and behind them: its time,
/// the port, quotation marks, as in `2023-12-31T23:59:30.120Z $GPHDT,75.5664,T*36`. Only where
/// nearly every line of the file's begin is such a one. Feed the blocks of the capture in order.
class SentenceStamps {
 public:
  /// The part of the block that a sensor said. Valid until the next call.
  wire::Bytes without(wire::Bytes block);
  std::uint64_t lines() const { return lines_; }  ///< that had a stamp

 private:
  void take(std::uint8_t byte);

  std::optional<bool> stamped_;  ///< the first block with some lines decides it
  std::vector<std::uint8_t> bytes_, before_;
  bool in_sentence_ = false;  ///< the present line
  unsigned behind_star_ = 0;
  std::uint64_t lines_ = 0;
};

/// True if nearly all whole lines of the text have a sentence of NMEA 0183 with a right checksum,
/// and something in front of it that is no TAG block. Empty: too few lines to tell.
std::optional<bool> has_sentence_stamps(wire::Bytes text);

}  // namespace drydock::capture
