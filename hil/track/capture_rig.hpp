#pragma once

#include <string>

#include "drivers/decode/replay.hpp"
#include "drivers/recordings/record/selection.hpp"
#include "rig_config/rig.hpp"

namespace drydock::track {

/// The rig of a capture of one sensor.
struct CaptureRig {
  rig_config::Rig rig;
  std::string text;           ///< its rig file
  std::string file;           ///< that the person named; empty: the rig was made from the options
  std::size_t device = 0;     ///< the sensor's place in the rig
  decode::ReplayOptions how;  ///< to play the capture through the driver that the rig describes
};

/// `rig_file`: a rig file with the sensor, which says its mounting, latency and sound speed. Among
/// several devices --protocol, --kind or `only` tell it. Empty: a rig with this sensor alone.
/// Throws std::invalid_argument with one line.
CaptureRig rig_of_capture(const decode::ReplayOptions& capture, const std::string& rig_file,
                          const std::vector<std::string>& only);

/// True if several devices of the rig file may have made the capture.
bool may_be_of_several(const decode::ReplayOptions& capture, const std::string& rig_file,
                       const std::vector<std::string>& only);

/// A rig file with this device alone, for a capture of it. `baud` 0: not known.
std::string capture_rig_text(const rig_config::DeviceConfig& device, unsigned baud);

}  // namespace drydock::track
