#include "drivers/terminal/hangup.hpp"

#include <csignal>

namespace drydock::terminal {

bool hangup_is_ignored() {
  static const bool ignored = [] {
    struct sigaction now {};
    return ::sigaction(SIGHUP, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
  }();
  return ignored;
}

}  // namespace drydock::terminal
