#pragma once

#include "drivers/decode/replay.hpp"

namespace drydock::replay {

/// When a capture begins and ends, by the clock that its times are of.
struct FileTimes {
  shell::RecordingClock clock = {};
  device::Travels travels = device::Travels::as_bytes;
  bool packets = false;  ///< a pcapng file, or pcap of a network: all that is in it has one clock
  measurement::Stamp first{}, last{};
  std::chrono::nanoseconds step{0};  ///< hardly one between two messages, reads, frames is longer

  bool told() const { return clock.pace != shell::Pace::line; }
  /// False: the times count from a midnight, or from the start of the recording.
  bool dated() const { return first.time_since_epoch() >= std::chrono::days{1}; }
};

/// `how` names the file and the driver. Throws std::exception with one line if it cannot be read.
FileTimes times_of_file(const decode::ReplayOptions& how);

}  // namespace drydock::replay
