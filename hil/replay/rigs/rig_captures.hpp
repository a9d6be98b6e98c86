#pragma once

#include <string>
#include <vector>

#include "drivers/decode/replay.hpp"

namespace drydock::replay {

/// Captures that are to be read by the devices of a rig. Several that are named for one device
/// follow each other (joined_series.hpp).
struct RigCaptures {
  struct File {
    std::string path;
    std::string device = {};  ///< the device that reads it; empty: those that it fits
    std::string folder = {};  ///< that was named in the place of its files; empty: the file was
    std::string format = {};  ///< its own, before that of all; empty: none
    std::string shown = {};   ///< its name for people; empty: its path
  };
  std::vector<File> files;
  /// How they are read: format, clock, interface, baud, bitrate and data_bitrate, where given, hold
  /// for all of them.
  decode::ReplayOptions how = {};
};

}  // namespace drydock::replay
