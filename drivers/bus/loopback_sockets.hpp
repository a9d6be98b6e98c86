#pragma once

#include <set>

namespace drydock::bus {

/// Cyclone DDS 0.10 receives on sockets that are bound to every address of the machine, whatever
/// interface it is configured for, and has no setting for it: anybody on the network could write to
/// a bus that says it stays on this host. This keeps the sockets that were opened in its lifetime
/// to the loopback interface.
class LoopbackSockets {
 public:
  LoopbackSockets();

  /// Throws std::system_error where the kernel does not let it (Linux before 5.7, without root).
  void keep_new_ones_to_loopback() const;

 private:
  std::set<int> before_;
};

}  // namespace drydock::bus
