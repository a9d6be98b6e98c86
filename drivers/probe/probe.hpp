#pragma once

#include <cstdio>
#include <string>

namespace drydock::probe {

struct ProbeOptions {
  std::string link;  ///< URI, `serial:` without a baud rate; or a bare /dev/... or CAN interface
  double duration_s = 30;
  bool ask = false;   ///< may write to the wire: docs/pier/probe.md lists what
  bool json = false;  ///< one JSON object
};

/// `drydock probe LINK`: which protocol at which rate, which sensors, and the `[[device]]` blocks
/// for a rig file. Without `ask` it never writes. A recording is read at once, in its own time.
/// Exit code: 0 something was found, 1 nothing was, 2 the link cannot be opened.
int probe(const ProbeOptions& options, std::FILE* out, std::FILE* err);

/// `drydock probe --all`: serial ports and CAN interfaces under `root`, "/" but in tests.
int probe_all(const std::string& root, bool json, std::FILE* out);

}  // namespace drydock::probe
