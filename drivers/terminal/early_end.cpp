#include "drivers/terminal/early_end.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>

#include "drivers/terminal/exit_codes.hpp"
#include "drivers/terminal/hangup.hpp"

namespace drydock::terminal {
namespace {

std::atomic<bool> early = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

}  // namespace

void note_early_end() { early = true; }
bool ended_early() { return early; }

void end_at_once(int) { ::_exit(exit_interrupted); }

void end_at_once_on_signals() {
  hangup_is_ignored();  // its first call
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (std::signal(signal, end_at_once) == SIG_IGN) std::signal(signal, SIG_IGN);
}

}  // namespace drydock::terminal
