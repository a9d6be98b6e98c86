#pragma once

#include <memory>
#include <vector>

#include "drivers/measurement/stamp.hpp"

namespace drydock::validity {

/// What this machine does to any program while something else runs: microseconds.
struct HostTimes {
  std::vector<double> timer_late_us;  ///< a bare steady_timer, each 5 ms, behind its time
  std::vector<double> pty_hop_us;     ///< a byte written to a bare pty until the other end has it
  std::vector<measurement::Stamp> timer_at, pty_at;  ///< when each was seen, link::steady_now()
};

/// Measures them from making to stop(), through Asio as everything here, on a thread a processor:
/// a virtual machine's host may hold up one of them alone. Where this program runs under SCHED_FIFO
/// the threads are one step ahead, so that what it does itself is not taken for the machine's.
class HostFloor {
 public:
  /// Throws std::system_error where there is no pty.
  HostFloor();
  ~HostFloor();
  HostTimes stop();

 private:
  struct Probe;
  std::vector<std::unique_ptr<Probe>> probes_;
};

}  // namespace drydock::validity
