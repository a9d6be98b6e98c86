#pragma once

namespace drydock::terminal {

/// Sends what a program still prints to /dev/null if its terminal has hung up, or if nobody reads
/// its pipe any more, where a line would be an error. Safe in a signal handler.
void leave_dead_terminal();

/// After leave_dead_terminal(), not in a signal handler: lines that nobody read are no failure of
/// standard output.
void forget_unread_lines();

/// What is printed into a pipe waits in memory for a flush, whose failure is no exception: a line
/// that nobody reads must not end a run. Call it before the first line.
void hold_lines_of_pipe();

}  // namespace drydock::terminal
