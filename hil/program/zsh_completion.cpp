#include <fmt/format.h>

#include "hil/program/completion.hpp"
#include "hil/program/completion_words.hpp"

namespace drydock::program {
namespace {

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

/// Values, and files beside the names of shipped ones.
std::string zsh_action(const CLI::Option& option) {
  const auto values = values_of(option);
  if (const auto names = shipped_names_of(option); !names.empty())
    return fmt::format("{{_files; compadd -- {} {}}}", joined(values), joined(names));
  if (values.empty()) return takes_file(option) ? "_files" : " ";
  return takes_list(option) ? fmt::format("{{_values -s , value {}}}", joined(values))
                            : fmt::format("({})", joined(values));
}

std::string zsh_devices(bool list) {
  return fmt::format("{{{} $(_drydock_devices $words[2])}}",
                     list ? "_values -s , value" : "compadd --");
}

std::string zsh_value(const CLI::App& command, const CLI::Option& option) {
  switch (rig_words_of(command, option)) {
    case RigWords::devices: return zsh_devices(takes_list(option));
    case RigWords::faults: return "{_values -s , value $(_drydock_faults $words[2] all)}";
    case RigWords::pairs: return "{compadd -- $(_drydock_faults $words[2] pairs)}";
    case RigWords::none: break;
  }
  return zsh_action(option);
}

/// `'(-o --output)'{-o,--output}'` if the option has a short name (zsh then offers one of both);
/// else the long name.
std::string zsh_names(const CLI::Option& option) {
  const std::string name = long_name(option);
  if (option.get_snames().empty()) return "'" + name;
  return fmt::format("'(-{0} {1})'{{-{0},{1}}}'", option.get_snames().front(), name);
}

std::string zsh_option(const CLI::App& command, const CLI::Option& option) {
  std::string text = fmt::format("{}[{}]", zsh_names(option), zsh_text(option.get_description()));
  if (is_flag(option)) return text + "'";
  const bool may_be_left_out = option.get_items_expected_min() == 0;
  return text +
         fmt::format("{}value:{}'", may_be_left_out ? "::" : ":", zsh_value(command, option));
}

/// What stands behind the rig: set, a device of the rig, a fault that it can have.
std::string zsh_fault_places(const CLI::App& fault) {
  std::vector<std::string> verbs;
  for (const auto* verb : commands_of(fault)) verbs.push_back(verb->get_name());
  return fmt::format(
      " \\\n        ':verb:({})' \\\n"
      "        ':device:{{compadd -- $(_drydock_faults $words[2])}}' \\\n"
      "        ':fault:{{compadd -- $(_drydock_faults $words[2] $words[4])}}'",
      joined(verbs));
}

std::string zsh_command(const CLI::App& command) {
  std::string text = fmt::format("    {})\n      _arguments", command.get_name());
  for (const auto* option : options_of(command))
    text += " \\\n        " + zsh_option(command, *option);
  for (const auto* option : positionals_of(command))
    text += fmt::format(" \\\n        '{}:{}:{}'", option->get_items_expected_max() > 1 ? "*" : "",
                        option->get_name(true), zsh_value(command, *option));
  if (command.get_name() == "fault") text += zsh_fault_places(command);
  return text + " ;;\n";
}

}  // namespace

std::string zsh_completion(const CLI::App& app) {
  std::string commands, cases;
  for (const auto* command : commands_of(app)) {
    commands +=
        fmt::format("    '{}:{}'\n", command->get_name(), zsh_text(command->get_description()));
    cases += zsh_command(*command);
  }
  return fmt::format(R"(#compdef drydock
# The devices of a rig, the faults of one of them or of all, or pairs of both: drydock fault RIG words says it.
_drydock_faults() {{
  drydock fault "$1" words 2>/dev/null | awk -v device="$2" '
    /^[^ ]/ {{ here = $1; if (device == "") print $1 }}
    /^  [a-z]/ && device == "pairs" {{ print here ":" $1 }}
    /^  [a-z]/ && (here == device || device == "all") && !said[$1]++ {{ print $1 }}'
}}
# The devices of a rig or of a recording.
_drydock_devices() {{
  local devices=$(_drydock_faults "$1")
  echo "${{devices:-$(drydock info "$1" 2>/dev/null | sed -n 's/^link .*: //p' | tr -d ,)}}"
}}
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
