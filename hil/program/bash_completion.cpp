#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "hil/program/completion.hpp"
#include "hil/program/completion_words.hpp"

namespace drydock::program {
namespace {

/// The words that an option's value may be, as one argument in the shell. Empty: they are not
/// known.
std::string bash_words(const CLI::App& command, const CLI::Option& option) {
  switch (rig_words_of(command, option)) {
    case RigWords::devices: return R"sh("$(_drydock_devices "${COMP_WORDS[2]}")")sh";
    case RigWords::pairs: return R"sh("$(_drydock_faults "${COMP_WORDS[2]}" pairs)")sh";
    case RigWords::faults: return R"sh("$(_drydock_faults "${COMP_WORDS[2]}" all)")sh";
    case RigWords::none: break;
  }
  auto values = values_of(option);
  std::ranges::move(shipped_names_of(option), std::back_inserter(values));
  return values.empty() ? "" : "'" + joined(values) + "'";
}

/// The shell function that offers these words.
std::string_view bash_offer(const CLI::App& command, const CLI::Option& option) {
  if (rig_words_of(command, option) == RigWords::pairs) return "_drydock_pair";
  return takes_list(option) ? "_drydock_list" : "_drydock_word";
}

/// The arms of the shell's `case "command previous-word"` for one command.
std::string bash_values(const CLI::App& command) {
  std::string arms;
  for (const auto* option : options_of(command)) {
    if (is_flag(*option)) continue;
    const auto key = fmt::format("'{} {}'", command.get_name(), long_name(*option));
    if (const auto words = bash_words(command, *option); !words.empty()) {
      arms += fmt::format("    {}) {} {}", key, bash_offer(command, *option), words);
      if (!shipped_names_of(*option).empty()) arms += "; COMPREPLY+=($(compgen -f -- \"$cur\"))";
      arms += "; return ;;\n";
    } else if (!takes_file(*option)) {
      arms += fmt::format("    {}) return ;;\n", key);
    }
  }
  return arms;
}

/// The options of a command behind which a value stands.
std::string options_with_value(const CLI::App& command) {
  std::vector<std::string> names;
  for (const auto* option : options_of(command))
    if (option->get_items_expected_min() > 0 && !is_flag(*option))
      for (const auto& name : option->get_lnames()) names.push_back("--" + name);
  return joined(names);
}

/// The arms of the shell's `case "command place"`, where place counts the words that are no option.
std::string bash_places(const CLI::App& command) {
  std::string arms;
  int place = 0;
  for (const auto* option : positionals_of(command)) {
    const auto key = fmt::format("'{} {}'", command.get_name(), place++);
    if (rig_words_of(command, *option) == RigWords::devices)
      arms += fmt::format(
          "    {}) _drydock_word \"$(_drydock_devices \"${{words[0]}}\")\"; return ;;\n", key);
    else if (const auto values = values_of(*option); !values.empty())
      arms += fmt::format("    {}) COMPREPLY=($(compgen -W '{}' -- \"$cur\")); return ;;\n", key,
                          joined(values));
    else if (const auto names = shipped_names_of(*option); !names.empty())
      arms += fmt::format("    {}) COMPREPLY=($(compgen -W '{}' -- \"$cur\")) ;;\n", key,
                          joined(names));
  }
  return arms;
}

std::vector<std::string> names_of(const std::vector<const CLI::App*>& commands) {
  std::vector<std::string> names;
  names.reserve(commands.size());
  for (const auto* command : commands) names.push_back(command->get_name());
  return names;
}

/// One arm of a `case $command`.
std::string arm(const CLI::App& command, const std::string& does) {
  return fmt::format("    {}) {} ;;\n", command.get_name(), does);
}

constexpr std::string_view script =
    R"sh(# bash completion for drydock: source <(drydock completion bash)
# The devices of a rig, the faults of one of them or of all, or pairs of both: drydock fault RIG words says it.
_drydock_faults() {
  drydock fault "$1" words 2>/dev/null | awk -v device="$2" '
    /^[^ ]/ { here = $1; if (device == "") print $1 }
    /^  [a-z]/ && device == "pairs" { print here ":" $1 }
    /^  [a-z]/ && (here == device || device == "all") && !said[$1]++ { print $1 }'
}
# The devices of a rig or of a recording.
_drydock_devices() {
  local devices=$(_drydock_faults "$1")
  echo "${devices:-$(drydock info "$1" 2>/dev/null | sed -n 's/^link .*: //p' | tr -d ,)}"
}
# The word that is typed, out of these; the last of a list with commas.
_drydock_word() { COMPREPLY=($(compgen -W "$1" -- "$cur")); }
_drydock_list() {
  local before=''
  [[ $cur != *,* ]] || before=${cur%,*},
  COMPREPLY=($(compgen -P "$before" -W "$1" -- "${cur##*,}"))
  compopt -o nospace 2>/dev/null
}
# The same for DEVICE:FAULT. Bash takes the colon for the end of a word, and puts in what is behind it.
_drydock_pair() {
  COMPREPLY=($(compgen -W "$1" -- "$before_colon$cur"))
  COMPREPLY=("${COMPREPLY[@]#$before_colon}")
}
_drydock() {
  local before_colon=''
  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]}
  local with_value='' i place=0 words=()
  COMPREPLY=()
  if ((COMP_CWORD > 3)) && [[ $cur == : ]]; then
    before_colon=$prev: cur='' prev=${COMP_WORDS[COMP_CWORD - 2]}
  elif ((COMP_CWORD > 4)) && [[ $prev == : ]]; then
    before_colon=${COMP_WORDS[COMP_CWORD - 2]}: prev=${COMP_WORDS[COMP_CWORD - 3]}
  fi
  if ((COMP_CWORD == 1)); then
    COMPREPLY=($(compgen -W '@COMMANDS --help --version' -- "$cur"))
    return
  fi
  case "$command $prev" in
@VALUES  esac
  if [[ $cur == -* ]]; then
    case $command in
@OPTIONS    esac
    return
  fi
  case $command in
@WITH_VALUE  esac
  for ((i = 2; i < COMP_CWORD; i++)); do
    if [[ " $with_value " == *" ${COMP_WORDS[i]} "* ]]; then
      ((i++))
    elif [[ ${COMP_WORDS[i]} != -* ]]; then
      words[place++]=${COMP_WORDS[i]}
    fi
  done
  case "$command $place" in
@PLACES    'fault 1') COMPREPLY=($(compgen -W '@VERBS' -- "$cur")); return ;;
    'fault 2') COMPREPLY=($(compgen -W "$(_drydock_faults "${words[0]}")" -- "$cur")); return ;;
    'fault 3')
      COMPREPLY=($(compgen -W "$(_drydock_faults "${words[0]}" "${words[2]}")" -- "$cur"))
      return ;;
    'help 0') COMPREPLY=($(compgen -W '@COMMANDS' -- "$cur")); return ;;
  esac
  COMPREPLY+=($(compgen -f -- "$cur"))
}
complete -o filenames -F _drydock drydock
)sh";

std::string filled(std::string text, std::string_view place, const std::string& with) {
  for (auto at = text.find(place); at != std::string::npos; at = text.find(place, at + with.size()))
    text.replace(at, place.size(), with);
  return text;
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  std::string values, options, with_value, places;
  for (const auto* command : commands_of(app)) {
    values += bash_values(*command);
    places += bash_places(*command);
    std::vector<std::string> names;
    for (const auto* option : options_of(*command)) names.push_back(long_name(*option));
    options +=
        arm(*command, fmt::format("COMPREPLY=($(compgen -W '{}' -- \"$cur\"))", joined(names)));
    with_value += arm(*command, fmt::format("with_value='{}'", options_with_value(*command)));
  }
  const auto* fault = app.get_subcommand("fault");
  std::string text = filled(std::string(script), "@COMMANDS", joined(names_of(commands_of(app))));
  text = filled(std::move(text), "@VERBS", joined(names_of(commands_of(*fault))));
  text = filled(std::move(text), "@VALUES", values);
  text = filled(std::move(text), "@OPTIONS", options);
  text = filled(std::move(text), "@WITH_VALUE", with_value);
  return filled(std::move(text), "@PLACES", places);
}

}  // namespace drydock::program
