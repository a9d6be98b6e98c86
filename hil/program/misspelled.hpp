#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace drydock::program {

/// One line that names the word which is no command, with the nearest command. Empty: the first
/// word is a command or an option, or there is none.
std::string misspelled_command(const CLI::App& app, int argc, const char* const* argv);

/// What CLI11 says of an argument that is missing; of a command, also which there are.
std::string missing_word(const CLI::App& app, const CLI::RequiredError& error);

/// What CLI11 says of a value that is not allowed; where it lists those that are, with the nearest.
std::string misspelled_value(const CLI::ValidationError& error);

/// What is wrong with a word that was not expected: with the nearest option of the command, or with
/// the words that the command takes.
std::string misspelled_option(const CLI::App& app, const CLI::ExtrasError& error);

}  // namespace drydock::program
