#pragma once

namespace drydock::terminal {

/// What becomes of a program whose output nobody reads any more: SIGPIPE kills it, as `head` wants
/// it, or it ends well and the rest of its lines goes nowhere.
enum class ClosedPipe : unsigned char { kills, ends };

/// While one of these lives, the first Ctrl-C, SIGTERM or SIGHUP only sets the flag. A second
/// Ctrl-C ends the program; a SIGHUP that hangup_is_ignored() stays so. Those that live at the same
/// time share the flag. This is for a loop that does not wait in io_context::run(); there
/// io::UntilStopped ends the program.
class InterruptFlag {
 public:
  explicit InterruptFlag(ClosedPipe closed_pipe = ClosedPipe::kills);
  ~InterruptFlag();
  InterruptFlag(const InterruptFlag&) = delete;
  InterruptFlag& operator=(const InterruptFlag&) = delete;

  bool set() const;  ///< from any thread
};

/// The signals of this process are another's, an interpreter's: from now on flags catch none, and
/// are set while `is_to_end` says so. Call it before the first flag.
void leave_signals_to(bool (*is_to_end)());

/// True if a flag that lives now is set. Safe from any thread; catches no signal itself.
bool interrupt_is_noted();

}  // namespace drydock::terminal
