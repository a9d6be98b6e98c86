#pragma once

#include <string>
#include <vector>

#include "drivers/decode/replay.hpp"

namespace drydock::replay {

/// Captures that are to be read by the devices of a rig.
struct RigCaptures {
  struct File {
    std::string path;
    std::string device = {};  ///< the device that reads it; empty: those that it fits
  };
  std::vector<File> files;
  /// How they are read: format, clock, interface, baud, bitrate and data_bitrate, where given, hold
  /// for all of them.
  decode::ReplayOptions how = {};
};

}  // namespace drydock::replay
