#pragma once

namespace drydock::terminal {

/// While one of these lives, the first Ctrl-C, SIGTERM or SIGHUP only sets the flag. A second
/// Ctrl-C ends the program. Those that live at the same time share the flag. This is for a loop
/// that does not wait in io_context::run(); there io::UntilStopped ends the program.
class InterruptFlag {
 public:
  InterruptFlag();
  ~InterruptFlag();
  InterruptFlag(const InterruptFlag&) = delete;
  InterruptFlag& operator=(const InterruptFlag&) = delete;

  bool set() const;  ///< from any thread
};

}  // namespace drydock::terminal
