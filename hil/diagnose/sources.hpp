#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hil/diagnose/outcome.hpp"

namespace drydock::device {
class Device;
}

namespace drydock::diagnose {

/// Listens to the devices of a rig for a time, or until Ctrl-C. Nothing is written to a wire.
/// `rates_stated`: by a person; else they are what was heard.
Outcome listen_to(const rig_config::Rig& rig, std::vector<std::unique_ptr<device::Device>> devices,
                  const std::string& source, double duration_s, bool rates_stated = true);

/// Probes a link for sensors, then listens to them. No devices: a note says what was heard. Throws
/// std::runtime_error with one line if the link cannot be opened.
Outcome listen_to_link(const std::string& link, double duration_s);

/// Plays a recording through the drivers and estimators of its rig. Throws std::runtime_error with
/// one line if it cannot be played.
Outcome read_recording(const std::string& path);

/// Finds the sensors in a capture of one link and plays it through their drivers. `baud` is that of
/// the recorded line; 0: not known. A capture of bytes has no times of arrival. No devices: a note
/// says what was found. Throws std::exception with one line if it cannot be read.
Outcome read_capture(const std::string& path, unsigned baud);

}  // namespace drydock::diagnose
