#pragma once

#include <cstdio>
#include <string>

#include "rig_config/rig.hpp"

namespace drydock::endurance {

struct SoakOptions {
  double duration_s = 30 * 86400.0;
  std::uint64_t seed = 1;         ///< of the sensors' errors and of the faults
  double fault_interval_s = 600;  ///< mean, per device
  bool faults = true;             ///< false: a healthy run, in which every finding is a false alarm
  double rest_s = 0;              ///< no fault begins for so long after each `burst_s` with faults
  /// From half of the run to its end: the system gives memory in pages. Before that, what the
  /// report keeps of a run (bounded) fills up.
  double most_growth_mb = 1;
  std::string json, report;  ///< file, folder; empty: none
};

/// Runs a rig in lockstep for a long time under random faults. It checks that memory does not grow,
/// that no device stays in a state without a fault, that every byte is accounted for, that every
/// number is finite, and that nothing is found while no device has a fault, nor still found in a
/// rest. Returns 0 if all is well, 1 if not, 130 after Ctrl-C.
int soak(rig_config::Rig rig, const SoakOptions& options, std::FILE* out);

}  // namespace drydock::endurance
