#pragma once

#include <map>
#include <string>
#include <vector>

#include "drivers/measurement/stamp.hpp"
#include "rig_config/rig.hpp"

namespace drydock::twin {

/// What one device of the twin has in place of the recorded one.
struct TwinDevice {
  std::string name;
  std::string errors;  ///< its sensor file, relative to the rig file; empty: it has no errors
  double rate_hz = 0;  ///< 0: as the rig says
};

struct TwinRig {
  measurement::Stamp start{};
  std::vector<TwinDevice> devices;           ///< others of the rig file are left out
  std::vector<std::string> estimators;       ///< that can be fed by them
  std::string folder;                        ///< of the recorded rig file
  std::map<std::string, std::string> files;  ///< that it names, as normal paths -> the twin's
};

/// The rig file of a recording with every link emulated, the measured rates and errors, and the
/// mission `mission.toml`. All other keys stay; [[expect]] and [[fault]] go. Throws
/// std::runtime_error with one line.
std::string twin_rig_text(const std::string& rig_text, const TwinRig& twin);

/// The emulated link in the place of a link: a pty of the device's name for bytes, with the same
/// rate; `can:auto` for frames. An emulated link stays.
std::string emulated_link(const std::string& link, const std::string& device, bool frames);

}  // namespace drydock::twin
