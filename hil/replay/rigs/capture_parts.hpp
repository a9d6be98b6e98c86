#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "drivers/decode/replay.hpp"

namespace drydock::replay {

/// A CAN bus or a line of bytes in a capture.
struct CapturePart {
  std::string file;
  std::string name = {};     ///< the interface or the line; empty: the file has no name for it
  bool frames = false;       ///< a bus
  std::uint64_t amount = 0;  ///< frames or bytes
  std::string format = {};   ///< of the file, where that was said; empty: its content tells it
  std::string shown = {};    ///< its file's name for people; empty: `file`
};

/// "can.asc, can1 (12 frames)", "dive.pd0 (5 bytes)".
std::string in_words(const CapturePart& part);

/// What a capture holds. `format` as in decode::ReplayOptions. Throws std::runtime_error with one
/// line if it cannot be read.
std::vector<CapturePart> parts_of(const std::string& file, const std::string& format);

/// How many measurements a driver makes of a part. `how` says the driver, and how captures are
/// read. Throws std::exception with one line if there is no such driver.
std::uint64_t measurements_of(const CapturePart& part, decode::ReplayOptions how);

}  // namespace drydock::replay
