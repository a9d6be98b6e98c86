#pragma once

#include <string>
#include <vector>

#include "drivers/diagnosis/cause.hpp"
#include "rig_config/rig.hpp"

namespace drydock::diagnose {

/// What was there to see with.
struct Circumstances {
  double duration_s = 0;
  bool live = false;                               ///< ports were open; else a file was read
  bool has_times = true;                           ///< messages have a time of arrival
  bool rates_stated = true;                        ///< a person wrote the rates of the devices
  std::vector<std::string> heads_with_depth = {};  ///< DVLs that told a depth which changed
};

/// Causes that could not have been seen on some devices, and why.
struct Unseen {
  std::vector<std::string> devices;
  std::vector<diagnosis::Cause> causes;
  std::string why;
};

/// Everything that could be wrong with the rig's devices and would not have been seen.
std::vector<Unseen> unseen_in(const rig_config::Rig& rig, const Circumstances& with);

/// Everything that would have been seen, but not where it was there from the start.
std::vector<Unseen> hidden_from_start(const rig_config::Rig& rig, const Circumstances& with);

/// True if only times of arrival can show it.
bool needs_times(diagnosis::Cause cause);

/// True if some signs lead to this cause.
bool is_concluded(diagnosis::Cause cause);

}  // namespace drydock::diagnose
