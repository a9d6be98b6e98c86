#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <span>

/// The command line: one table of commands. Each is a file of hil/program/commands that holds its
/// options and its call.
namespace drydock::program {

/// What the command line chose: exactly one subcommand's callback sets it. Gives the exit code.
using Command = std::function<int()>;

/// Adds a subcommand, with its options, to the program.
using AddCommand = void (*)(CLI::App& app, Command& command);

/// All of them, in the order of the help.
std::span<const AddCommand> commands();

}  // namespace drydock::program
