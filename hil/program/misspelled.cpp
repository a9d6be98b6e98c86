#include "hil/program/misspelled.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rig_config/rules/explain.hpp"

namespace drydock::program {
namespace {

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const auto* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

std::vector<std::string> names_of_options(const CLI::App& command) {
  std::vector<std::string> names;
  for (const auto* option : command.get_options())
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// "RIG, RECORDING"; the words that need no name before them.
std::string words_of(const CLI::App& command) {
  std::vector<std::string> words;
  for (const auto* option : command.get_options())
    if (option->get_positional()) words.push_back(option->get_name(true));
  return words.empty() ? "no word" : rig_config::listed(words);
}

/// The innermost command of those that were typed.
const CLI::App& typed_command(const CLI::App& app) {
  const auto typed = app.get_subcommands();
  return typed.empty() ? app : typed_command(*typed.front());
}

}  // namespace

std::string misspelled_command(const CLI::App& app, int argc, const char* const* argv) {
  const std::string word = argc > 1 ? argv[1] : "";
  const auto names = names_of_commands(app);
  if (word.empty() || word.starts_with('-') || std::ranges::find(names, word) != names.end())
    return "";
  return fmt::format("drydock: '{}' is no command{}; drydock --help lists them", word,
                     rig_config::did_you_mean(word, names));
}

std::string missing_word(const CLI::App& app, const CLI::RequiredError& error) {
  const auto& command = typed_command(app);
  const auto names = names_of_commands(command);
  std::string text = error.what();
  if (names.empty() || text.find("subcommand") == std::string::npos) return text;
  if (&command == &app) return "drydock: which command? drydock --help lists them";
  return fmt::format("{}: which? one of {}", command.get_name(), rig_config::listed(names));
}

/// CLI11 has no other access to the list: "KIND: sensr not in {rig,sensor}".
std::string misspelled_value(const CLI::ValidationError& error) {
  std::string text = error.what();
  const auto list = text.find(" not in {"), end = text.rfind('}');
  const auto name = text.find(": ");
  if (list == std::string::npos || end == std::string::npos || !(name < list)) return text;
  const auto word = text.substr(name + 2, list - name - 2);
  const auto begin = list + std::string_view(" not in {").size();
  return text +
         rig_config::did_you_mean(word, CLI::detail::split(text.substr(begin, end - begin), ','));
}

std::string misspelled_option(const CLI::App& app, const CLI::ExtrasError& error) {
  const auto& command = typed_command(app);
  const auto unknown = command.remaining();
  if (unknown.empty()) return error.what();
  if (!unknown.front().starts_with('-'))
    return fmt::format(
        "{}: '{}' is one word too many; it takes {}, and any other value behind the name of its "
        "option, as --name value",
        command.get_name(), unknown.front(), words_of(command));
  if (!unknown.front().starts_with("--")) return error.what();
  const auto name = unknown.front().substr(0, unknown.front().find('='));
  return fmt::format("{}: there is no option {}{}", command.get_name(), unknown.front(),
                     rig_config::did_you_mean(name, names_of_options(command)));
}

}  // namespace drydock::program
