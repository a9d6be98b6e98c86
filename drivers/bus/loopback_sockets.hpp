#pragma once

#include <set>

namespace drydock::bus {

/// Cyclone DDS 0.10 receives on sockets that are bound to every address of the machine, whatever
/// interface it is configured for. It has no setting to change this, so anybody on the network
/// could write to a bus that should stay on this host. This class binds the sockets that were
/// opened in its lifetime to the loopback interface.
class LoopbackSockets {
 public:
  LoopbackSockets();

  /// Throws std::system_error if the kernel does not permit it (Linux before 5.7, without root).
  void keep_new_ones_to_loopback() const;

 private:
  std::set<int> before_;
};

}  // namespace drydock::bus
