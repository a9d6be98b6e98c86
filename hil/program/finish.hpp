#pragma once

namespace drydock::program {

/// The exit code of the whole program, from that of a command: 1 where standard output did not take
/// what was printed, which it says, and exit_interrupted where a signal came before the end.
int finish(int code);

}  // namespace drydock::program
