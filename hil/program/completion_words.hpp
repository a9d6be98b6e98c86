#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

/// What the scripts of all shells take from the description of the command line.
namespace drydock::program {

std::vector<const CLI::App*> commands_of(const CLI::App& app);
bool is_flag(const CLI::Option& option);

/// The words of "{1,max}" in a type name, or those after "one of " in a description, up to a
/// semicolon. Empty if any value is allowed.
std::vector<std::string> values_of(const CLI::Option& option);

/// True for "TEXT:PATH(existing)", false for a number or a duration.
bool takes_file(const CLI::Option& option);

std::string long_name(const CLI::Option& option);

/// Named options, without positional ones.
std::vector<const CLI::Option*> options_of(const CLI::App& command);
std::vector<const CLI::Option*> positionals_of(const CLI::App& command);
std::string joined(const std::vector<std::string>& words);

/// The shipped files that a positional may name: rigs for RIG, and so on. Empty: none.
std::vector<std::string> shipped_names_of(const CLI::Option& positional);

}  // namespace drydock::program
