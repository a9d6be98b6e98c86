#include "drivers/io/scheduling.hpp"

#include <sched.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace drydock::io {
namespace {

SchedulingError refused(const std::string& what, const std::string& advice) {
  return {"the kernel refuses " + what + ": " + std::generic_category().message(errno) + advice};
}

}  // namespace

boost::system::result<void, SchedulingError> claim(const Scheduling& wanted) {
  if (!wanted.cores.empty()) {
    cpu_set_t set;
    CPU_ZERO(&set);
    for (const unsigned core : wanted.cores) CPU_SET(core, &set);
    if (::sched_setaffinity(0, sizeof set, &set) != 0) {
      return refused("these cores", " (this machine has the cores 0 to " +
                                        std::to_string(::sysconf(_SC_NPROCESSORS_CONF) - 1) + ")");
    }
  }
  if (::mlockall(MCL_CURRENT | MCL_FUTURE) != 0)
    return refused("to lock the memory",
                   " ('drydock doctor' says how to allow it; in a unit LimitMEMLOCK=infinity)");
  const sched_param parameters{.sched_priority = wanted.priority};
  if (::sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &parameters) != 0) {
    const auto error =
        refused("SCHED_FIFO at priority " + std::to_string(wanted.priority),
                " ('drydock doctor' says how to allow it; in a unit LimitRTPRIO=99)");
    ::munlockall();
    return error;
  }
  return {};
}

}  // namespace drydock::io
