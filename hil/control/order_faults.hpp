#pragma once

#include <string>
#include <vector>

#include "rig_config/rig.hpp"

namespace drydock::control {

struct FaultOptions {
  std::string device, fault;       ///< empty: all
  std::vector<std::string> pairs;  ///< "probability=0.5"
  double for_s = 0;                ///< 0: until cleared
  bool json = false;
};

/// `drydock fault`: asks the running bench of that rig and prints its answer. Exit code; throws
/// std::runtime_error with a line when none runs.
int set_fault(const rig_config::Rig& rig, const FaultOptions& options);
int clear_faults(const rig_config::Rig& rig, const FaultOptions& options);
int list_faults(const rig_config::Rig& rig, const FaultOptions& options);

/// Which faults each device can have; no bench need run.
int show_fault_words(const rig_config::Rig& rig, const FaultOptions& options);

/// Puts the faults of a file beside those of the rig. Throws BadRig, the lines printed, where the
/// file is wrong or this program cannot do what it says. An empty path: those of the rig alone.
void add_faults(rig_config::Rig& rig, const std::string& path);

}  // namespace drydock::control
