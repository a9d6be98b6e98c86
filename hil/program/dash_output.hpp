#pragma once

#include <CLI/CLI.hpp>

/// `-` in the place of a file of text, as in `run --json -`, is standard output. What the command
/// prints besides goes to standard error, so that the file alone comes through a pipe.
namespace drydock::program {

/// The option takes a dash: one option of a command line may.
void take_dash(CLI::Option& option);

/// Behind parsing: from here on standard output is kept for the file, if one is a dash.
void begin_dash();

/// Behind the command: the file goes out.
void end_dash();

}  // namespace drydock::program
