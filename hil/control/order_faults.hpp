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

/// `drydock fault`: sends an order to the running bench of that rig and prints its answer. Returns
/// the exit code; throws std::runtime_error with one line when no bench runs.
int set_fault(const rig_config::Rig& rig, const FaultOptions& options);
int clear_faults(const rig_config::Rig& rig, const FaultOptions& options);
int list_faults(const rig_config::Rig& rig, const FaultOptions& options);

/// Prints the faults that each device can have. It needs no running bench.
int show_fault_words(const rig_config::Rig& rig, const FaultOptions& options);

}  // namespace drydock::control
