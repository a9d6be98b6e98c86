#include "drivers/terminal/interrupt_flag.hpp"

#include <array>
#include <atomic>
#include <csignal>
#include <mutex>

#include "drivers/terminal/dead_terminal.hpp"
#include "drivers/terminal/early_end.hpp"

namespace drydock::terminal {
namespace {

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

constexpr std::array ends{SIGINT, SIGTERM, SIGHUP};

std::mutex mutex;  // protects both
int alive = 0;
std::array<void (*)(int), ends.size()> before;  // by signal

/// A shell and the kernel both send a SIGHUP: the second must not disturb the end.
void on_end(int signal) {
  interrupted = true;
  note_early_end();  // a loop that only a signal breaks off has an end of its own
  leave_dead_terminal();
  std::signal(signal, signal == SIGHUP ? SIG_IGN : end_at_once);
}

}  // namespace

InterruptFlag::InterruptFlag() {
  const std::lock_guard lock(mutex);
  if (alive++ > 0) return;
  interrupted = false;
  for (std::size_t i = 0; i < ends.size(); ++i) before[i] = std::signal(ends[i], on_end);
}

InterruptFlag::~InterruptFlag() {
  const std::lock_guard lock(mutex);
  if (--alive > 0) return;
  for (std::size_t i = 0; i < ends.size(); ++i) std::signal(ends[i], before[i]);
}

bool InterruptFlag::set() const { return interrupted; }

}  // namespace drydock::terminal
