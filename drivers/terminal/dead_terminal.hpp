#pragma once

namespace drydock::terminal {

/// Sends what a program still prints to /dev/null if its terminal has hung up, where a line on the
/// screen would be an error. Safe in a signal handler.
void leave_dead_terminal();

}  // namespace drydock::terminal
