#pragma once

namespace drydock::terminal {

/// While one of these lives, the first Ctrl-C only sets the flag. The second ends the program. This
/// is for a loop that does not wait in io_context::run(); there io::UntilStopped ends the program.
class InterruptFlag {
 public:
  InterruptFlag();
  ~InterruptFlag();
  InterruptFlag(const InterruptFlag&) = delete;
  InterruptFlag& operator=(const InterruptFlag&) = delete;

  bool set() const;  ///< from any thread

 private:
  void (*before_)(int);
};

}  // namespace drydock::terminal
