#pragma once

#include <array>

namespace drydock::terminal {

/// While one of these lives, the first Ctrl-C, SIGTERM or SIGHUP only sets the flag. A second
/// Ctrl-C ends the program. This is for a loop that does not wait in io_context::run(); there
/// io::UntilStopped ends the program.
class InterruptFlag {
 public:
  InterruptFlag();
  ~InterruptFlag();
  InterruptFlag(const InterruptFlag&) = delete;
  InterruptFlag& operator=(const InterruptFlag&) = delete;

  bool set() const;  ///< from any thread

 private:
  std::array<void (*)(int), 3> before_;  ///< by signal
};

}  // namespace drydock::terminal
