#include "hil/program/completion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace drydock::program {
namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

bool is_flag(const CLI::Option& option) { return option.get_items_expected_max() == 0; }

/// The words of "{1,max}" in a type name, or those after "one of " in a description. Empty if any
/// value is allowed.
std::vector<std::string> values_of(const CLI::Option& option) {
  std::string list;
  const std::string type = option.get_type_name();
  const std::string& text = option.get_description();
  if (const auto brace = type.find('{'); brace != std::string::npos) {
    list = type.substr(brace + 1, type.find('}') - brace - 1);
  } else if (const auto one_of = text.find("one of "); one_of != std::string::npos) {
    list = text.substr(one_of + 7);
  }
  std::vector<std::string> values;
  std::istringstream in(list);
  for (std::string value; std::getline(in, value, ',');) {
    value.erase(0, value.find_first_not_of(' '));
    if (!value.empty() && value.find(' ') == std::string::npos) values.push_back(value);
  }
  return values;
}

/// True for "TEXT:PATH(existing)", false for a number or a duration.
bool takes_file(const CLI::Option& option) {
  return !is_flag(option) && option.get_type_name().starts_with("TEXT") &&
         values_of(option).empty();
}

std::string long_name(const CLI::Option& option) { return "--" + option.get_lnames().front(); }

/// Named options, without positional ones.
std::vector<const CLI::Option*> options_of(const CLI::App& command) {
  return command.get_options([](const CLI::Option* o) { return !o->get_lnames().empty(); });
}

std::vector<const CLI::Option*> positionals_of(const CLI::App& command) {
  return command.get_options([](const CLI::Option* o) { return o->get_positional(); });
}

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

/// The arms of the shell's `case "command previous-word"` for one command.
std::string bash_values(const CLI::App& command) {
  std::string arms;
  const auto arm = [&](const std::string& key, const CLI::Option& option) {
    if (const auto values = values_of(option); !values.empty())
      arms += fmt::format("    '{} {}') COMPREPLY=($(compgen -W '{}' -- \"$cur\")); return ;;\n",
                          command.get_name(), key, joined(values));
    else if (!takes_file(option))
      arms += fmt::format("    '{} {}') return ;;\n", command.get_name(), key);
  };
  for (const auto* option : options_of(command))
    if (!is_flag(*option)) arm(long_name(*option), *option);
  for (const auto* option : positionals_of(command))
    if (!values_of(*option).empty()) arm(command.get_name(), *option);
  return arms;
}

/// Escapes a description for zsh's `_arguments` within single quotes: brackets, colons and quotes
/// have a meaning there.
std::string zsh_text(std::string text) {
  text = text.substr(0, text.find('\n'));
  std::string out;
  for (const char c : text) {
    if (c == '\'')
      out += "'\\''";
    else
      out += c == ':' || c == '[' || c == ']' ? std::string("\\") + c : std::string(1, c);
  }
  return out;
}

std::string zsh_action(const CLI::Option& option) {
  if (const auto values = values_of(option); !values.empty())
    return fmt::format("({})", joined(values));
  return takes_file(option) ? "_files" : " ";
}

/// `'(-o --output)'{-o,--output}'` if the option has a short name (zsh then offers one of both);
/// else the long name.
std::string zsh_names(const CLI::Option& option) {
  const std::string name = long_name(option);
  if (option.get_snames().empty()) return "'" + name;
  return fmt::format("'(-{0} {1})'{{-{0},{1}}}'", option.get_snames().front(), name);
}

std::string zsh_option(const CLI::Option& option) {
  std::string text = fmt::format("{}[{}]", zsh_names(option), zsh_text(option.get_description()));
  if (is_flag(option)) return text + "'";
  const bool may_be_left_out = option.get_items_expected_min() == 0;
  return text + fmt::format("{}value:{}'", may_be_left_out ? "::" : ":", zsh_action(option));
}

std::string zsh_command(const CLI::App& command) {
  std::string text = fmt::format("    {})\n      _arguments", command.get_name());
  for (const auto* option : options_of(command)) text += " \\\n        " + zsh_option(*option);
  for (const auto* option : positionals_of(command))
    text += fmt::format(" \\\n        '{}:{}:{}'", option->get_items_expected_max() > 1 ? "*" : "",
                        option->get_name(true), zsh_action(*option));
  return text + " ;;\n";
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  std::vector<std::string> names;
  std::string values, options;
  for (const auto* command : commands_of(app)) {
    names.push_back(command->get_name());
    values += bash_values(*command);
    std::vector<std::string> flags;
    for (const auto* option : options_of(*command)) flags.push_back(long_name(*option));
    options += fmt::format("      {}) COMPREPLY=($(compgen -W '{}' -- \"$cur\")) ;;\n",
                           command->get_name(), joined(flags));
  }
  return fmt::format(R"(# bash completion for drydock: source <(drydock completion bash)
_drydock() {{
  local cur=${{COMP_WORDS[COMP_CWORD]}} prev=${{COMP_WORDS[COMP_CWORD - 1]}} command=${{COMP_WORDS[1]}}
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    COMPREPLY=($(compgen -W '{} --help --version' -- "$cur"))
    return
  fi
  case "$command $prev" in
{}  esac
  if [[ $cur == -* ]]; then
    case $command in
{}    esac
  else
    COMPREPLY=($(compgen -f -- "$cur"))
  fi
}}
complete -o filenames -F _drydock drydock
)",
                     joined(names), values, options);
}

std::string zsh_completion(const CLI::App& app) {
  std::string commands, cases;
  for (const auto* command : commands_of(app)) {
    commands +=
        fmt::format("    '{}:{}'\n", command->get_name(), zsh_text(command->get_description()));
    cases += zsh_command(*command);
  }
  return fmt::format(R"(#compdef drydock
_drydock() {{
  local -a commands=(
{}  )
  if ((CURRENT == 2)); then
    _describe command commands
    return
  fi
  shift words
  ((CURRENT--))
  case $words[1] in
{}  esac
}}
# Called by the completion system, or read by `source <(drydock completion zsh)`.
if [[ $funcstack[1] == _drydock ]]; then _drydock "$@"; else compdef _drydock drydock; fi
)",
                     commands, cases);
}

}  // namespace drydock::program
