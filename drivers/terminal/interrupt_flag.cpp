#include "drivers/terminal/interrupt_flag.hpp"

#include <atomic>
#include <csignal>

namespace drydock::terminal {
namespace {

std::atomic<bool> ctrl_c = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

void on_ctrl_c(int) {
  ctrl_c = true;
  std::signal(SIGINT, SIG_DFL);
}

}  // namespace

InterruptFlag::InterruptFlag() : before_(std::signal(SIGINT, on_ctrl_c)) { ctrl_c = false; }

InterruptFlag::~InterruptFlag() { std::signal(SIGINT, before_); }

bool InterruptFlag::set() const { return ctrl_c; }

}  // namespace drydock::terminal
