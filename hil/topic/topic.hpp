#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

#include "rig_config/rig.hpp"

namespace drydock::topic {

struct EchoOptions {
  std::string name;        ///< of a device, an estimator or a topic; empty: all
  double duration_s = 0;   ///< of a live bus; 0: until Ctrl-C
  std::uint64_t most = 0;  ///< messages, then it ends; 0: no limit
};

/// Prints the messages of a recording as JSON lines. Returns the exit code: 1 if there is none.
int echo_recording(const std::string& file, const EchoOptions& options, std::FILE* out,
                   std::FILE* err);

/// Prints what the drivers and the attitude estimators of a rig, in whatever process, say on the
/// bus, as JSON lines. Returns the exit code: 1 if nothing came, 2 if the rig has no such source.
int echo_bus(const rig_config::Rig& rig, const EchoOptions& options, std::FILE* out,
             std::FILE* err);

}  // namespace drydock::topic
