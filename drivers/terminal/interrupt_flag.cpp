#include "drivers/terminal/interrupt_flag.hpp"

#include <array>
#include <atomic>
#include <csignal>
#include <mutex>

#include "drivers/terminal/dead_terminal.hpp"
#include "drivers/terminal/early_end.hpp"
#include "drivers/terminal/hangup.hpp"

namespace drydock::terminal {
namespace {

std::atomic<bool> interrupted = false, unread = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

bool (*other)() = nullptr;  // whose the signals are; null: this program's

constexpr std::array ends{SIGINT, SIGTERM, SIGHUP, SIGPIPE};

std::mutex mutex;  // protects both
int alive = 0;
std::array<void (*)(int), ends.size()> before;  // by signal
std::size_t caught = 0;                         // the first ones of `ends`

/// Calls `change(i)` for each signal that is caught.
template <class Change>
void for_each_caught(Change&& change) {
  for (std::size_t i = 0; i < caught; ++i)
    if (ends[i] != SIGHUP || !hangup_is_ignored()) change(i);
}

/// A shell and the kernel both send a SIGHUP: the second must not disturb the end. Neither must a
/// second line that nobody reads.
void on_end(int signal) {
  interrupted = true;
  unread = unread || signal == SIGPIPE;
  note_early_end();  // a loop that only a signal breaks off has an end of its own
  leave_dead_terminal();
  std::signal(signal, signal == SIGHUP || signal == SIGPIPE ? SIG_IGN : end_at_once);
}

}  // namespace

void leave_signals_to(bool (*is_to_end)()) { other = is_to_end; }

InterruptFlag::InterruptFlag(ClosedPipe closed_pipe) {
  if (other != nullptr) return;
  const std::lock_guard lock(mutex);
  if (alive++ > 0) return;
  interrupted = false;
  caught = ends.size() - (closed_pipe == ClosedPipe::kills);
  for_each_caught([](std::size_t i) { before[i] = std::signal(ends[i], on_end); });
}

InterruptFlag::~InterruptFlag() {
  if (other != nullptr) return;
  const std::lock_guard lock(mutex);
  if (--alive > 0) return;
  for_each_caught([](std::size_t i) { std::signal(ends[i], before[i]); });
  if (unread.exchange(false)) forget_unread_lines();
}

bool interrupt_is_noted() {
  const std::lock_guard lock(mutex);
  return alive > 0 && interrupted;
}

bool InterruptFlag::set() const { return other != nullptr ? other() : interrupted.load(); }

}  // namespace drydock::terminal
