#pragma once

#include <boost/system/result.hpp>
#include <optional>
#include <string>
#include <vector>

namespace drydock::io {

/// What a program asks of the kernel so that its loop is late less often (sched(7), mlockall(2)).
struct Scheduling {
  static constexpr int default_priority = 50;  ///< that of threaded interrupts on PREEMPT_RT

  int priority = default_priority;  ///< of SCHED_FIFO, 1 to 99
  std::vector<unsigned> cores;      ///< the processors that may run the loop, from 0; empty: all
};

/// The kernel refused: one line with what it refused and the setting that allows it.
struct SchedulingError {
  std::string message;
};

/// Makes the calling thread SCHED_FIFO on these processors, and keeps the program's memory
/// resident. Threads that this thread starts later, such as the recorder's, run with normal
/// priority.
boost::system::result<void, SchedulingError> claim(const Scheduling& wanted);

}  // namespace drydock::io
