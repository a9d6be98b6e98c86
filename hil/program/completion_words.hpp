#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

/// What the scripts of all shells take from the description of the command line.
namespace drydock::program {

std::vector<const CLI::App*> commands_of(const CLI::App& app);
bool is_flag(const CLI::Option& option);

/// The words of "{1,max}" in a type name, or those after "one of " or "out of " in a description,
/// up to a semicolon. Empty if any value is allowed.
std::vector<std::string> values_of(const CLI::Option& option);

/// True for "TEXT:PATH(existing)", false for a number or a duration.
bool takes_file(const CLI::Option& option);

std::string long_name(const CLI::Option& option);

/// Named options, without positional ones.
std::vector<const CLI::Option*> options_of(const CLI::App& command);
std::vector<const CLI::Option*> positionals_of(const CLI::App& command);
std::string joined(const std::vector<std::string>& words);

/// The shipped files that an argument may name beside other files: rigs for RIG, descriptions for
/// --protocol, and so on. Empty: none.
std::vector<std::string> shipped_names_of(const CLI::Option& option);

/// True if the value is a list with commas: kn,bar.
bool takes_list(const CLI::Option& option);

/// What the shell asks the program for when it completes the values of an option or of a place:
/// devices of the rig or recording at hand, words of their faults, or both as DEVICE:FAULT.
enum class RigWords : std::uint8_t { none, devices, faults, pairs };
RigWords rig_words_of(const CLI::App& command, const CLI::Option& option);

}  // namespace drydock::program
