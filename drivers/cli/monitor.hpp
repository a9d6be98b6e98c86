#pragma once

#include <string>

namespace drydock::cli {

struct MonitorOptions {
  std::string link;       ///< URI
  std::string protocol;   ///< as in a rig file
  double duration_s = 0;  ///< 0: until Ctrl-C
};

/// Listens on a link and prints what it says: each message as a JSON line on standard output, a
/// line of counters on standard error every two seconds. Never writes to the wire.
/// Returns 0 when at least one message came, 1 when none did, 2 when the link could not be opened.
int monitor(const MonitorOptions& options);

}  // namespace drydock::cli
