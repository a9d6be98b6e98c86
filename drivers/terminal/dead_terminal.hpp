#pragma once

namespace drydock::terminal {

/// Sends what a program still prints to /dev/null if its terminal has hung up, or if nobody reads
/// its pipe any more, where a line would be an error. Safe in a signal handler.
void leave_dead_terminal();

}  // namespace drydock::terminal
