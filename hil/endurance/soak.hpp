#pragma once

#include <cstdio>
#include <string>

#include "rig_config/rig.hpp"

namespace drydock::endurance {

struct SoakOptions {
  double duration_s = 30 * 86400.0;
  std::uint64_t seed = 1;         ///< of the faults
  double fault_interval_s = 600;  ///< mean, of one device
  std::string json, report;       ///< file, folder; empty: none
};

/// A rig in lockstep for a long time under random faults: whether its memory grows, a device stays
/// in a state that no fault explains, a byte is not accounted for, a number is none. 0: nothing of
/// the kind; 1: something.
int soak(const rig_config::Rig& rig, const SoakOptions& options, std::FILE* out);

}  // namespace drydock::endurance
