#pragma once

#include <cstdio>
#include <string>

#include "rig_config/rig.hpp"

/// `drydock load`: checks whether this machine keeps every deadline of a rig.
/// docs/sensors/time-of-validity.md
namespace drydock::endurance {

struct LoadOptions {
  double duration_s = 600;
  std::string json;  ///< file; empty: none
};

/// Runs the rig's emulated devices and their drivers in real time, beside a measurement of the
/// machine's own timers. Prints a table, a line for each problem and a verdict to `out`; shows a
/// bar on `bar` if it is a terminal. Returns 0 if every deadline was kept, nothing was lost and
/// every rate was held; 130 after Ctrl-C; else exit_failed. Throws std::runtime_error with one line
/// if the rig cannot run.
int load_run(const rig_config::Rig& rig, const LoadOptions& options, std::FILE* out,
             std::FILE* bar);

}  // namespace drydock::endurance
