#pragma once

namespace drydock::terminal {

/// Signals end a program before its work is done: the rule of the exit codes asks for that.
/// Safe in a signal handler and from any thread.
void note_early_end();
bool ended_early();

/// From now on SIGINT, SIGTERM and SIGHUP end the program at once, with terminal::exit_interrupted.
/// A signal that the parent of this program ignores stays ignored.
void end_at_once_on_signals();

/// That handler, for those who catch a first signal themselves.
void end_at_once(int signal);

}  // namespace drydock::terminal
