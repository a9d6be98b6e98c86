#pragma once

#include <cstdio>
#include <string>

#include "rig_config/rig.hpp"

/// `drydock load`: whether this machine keeps every deadline of a rig.
/// docs/sensors/time-of-validity.md
namespace drydock::cli {

struct LoadOptions {
  double duration_s = 600;
  std::string json;  ///< file; empty: none
};

/// The rig's emulated devices and their drivers in real time, beside the machine's own timers: a
/// table, a line for each trouble and one verdict to `out`, a bar to `bar` where it is a terminal.
/// 0: every deadline kept, nothing lost, every rate held; 130: ended by Ctrl-C; else exit_failed.
/// Throws std::runtime_error with one line where the rig cannot run.
int load_run(const rig_config::Rig& rig, const LoadOptions& options, std::FILE* out,
             std::FILE* bar);

}  // namespace drydock::cli
