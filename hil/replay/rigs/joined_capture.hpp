#pragma once

#include <memory>
#include <string>
#include <vector>

#include "drivers/decode/replay.hpp"
#include "hil/replay/rigs/temporary_file.hpp"

namespace drydock::replay {

/// Captures of one sensor that follow each other, as one.
struct JoinedCapture {
  std::shared_ptr<const TemporaryFile> file;
  std::string format;              ///< of that file; empty: its content tells it
  std::string shown;               ///< the names of the captures
  std::vector<std::string> notes;  ///< their order, gaps and overlaps: sentences for a person
};

/// Puts captures into one file, in the order of their times: a logger may begin a new file where it
/// likes, in the middle of a frame too. Without times that can be compared they stand as given.
/// What a capture has again of the one before is left out, but for packets and lines that have
/// their own times. `how` says the driver, and how the captures are read. Throws std::exception
/// with one line if one cannot be read.
JoinedCapture join(const std::vector<std::string>& files, const decode::ReplayOptions& how);

}  // namespace drydock::replay
