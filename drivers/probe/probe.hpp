#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace drydock::wire::described {
struct Description;
}

namespace drydock::probe {

struct ProbeOptions {
  std::string link;  ///< URI, `serial:` without a baud rate; or only /dev/... or a CAN interface
  double duration_s = 30;
  bool ask = false;   ///< may write to the wire: docs/pier/probe.md lists the questions
  bool json = false;  ///< one JSON object
  /// Protocols that the user's files describe, tried beside those of the registry. Byte lines are
  /// also tried for those that the program contains.
  std::vector<std::shared_ptr<const wire::described::Description>> descriptions{};
};

/// `drydock probe LINK`: finds the protocol, its rate and the sensors, and prints the `[[device]]`
/// blocks for a rig file. Without `ask` it never writes. It reads a recording at once, in the
/// recording's own time; one without times by the device's clock. Exit code: 0 something was found
/// and nothing is wrong, 1 something is wrong (problems_of) or the link cannot be opened, 2 the
/// link is no link.
int probe(const ProbeOptions& options, std::FILE* out, std::FILE* err);

/// `drydock probe --all`: serial ports and CAN interfaces under `root`, which is "/" except in
/// tests.
int probe_all(const std::string& root, bool json, std::FILE* out);

}  // namespace drydock::probe
