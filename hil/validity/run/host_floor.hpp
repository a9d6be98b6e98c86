#pragma once

#include <memory>
#include <vector>

#include "drivers/measurement/stamp.hpp"

namespace drydock::validity {

/// Delays that this machine causes in any program, microseconds.
struct HostTimes {
  std::vector<double> timer_late_us;  ///< lateness of a bare steady_timer that expires every 5 ms
  std::vector<double> pty_hop_us;     ///< from the write of one byte to a bare pty until the other
                                      ///< end reads it
  std::vector<measurement::Stamp> timer_at, pty_at;  ///< when each value was taken,
                                                     ///< link::steady_now()
};

/// Measures from construction to stop(), with Asio as all of this program. One thread runs on each
/// processor, because the host of a virtual machine may delay one processor alone. If this program
/// runs under SCHED_FIFO, the threads have the next higher priority, so that the load of this
/// program does not count as a delay of the machine.
class HostFloor {
 public:
  /// Throws std::system_error if no pty can be made.
  HostFloor();
  ~HostFloor();
  HostTimes stop();

 private:
  struct Probe;
  std::vector<std::unique_ptr<Probe>> probes_;
};

}  // namespace drydock::validity
