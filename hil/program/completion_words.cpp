#include "hil/program/completion_words.hpp"

#include <fmt/format.h>

#include <sstream>
#include <utility>

#include "rig_config/device_description/load_description.hpp"
#include "rig_config/shipped.hpp"

namespace drydock::program {

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

bool is_flag(const CLI::Option& option) { return option.get_items_expected_max() == 0; }

std::vector<std::string> values_of(const CLI::Option& option) {
  std::string list;
  const std::string type = option.get_type_name();
  const std::string& text = option.get_description();
  if (const auto brace = type.find('{'); brace != std::string::npos) {
    list = type.substr(brace + 1, type.find('}') - brace - 1);
  } else {
    for (const std::string_view before : {"one of ", "out of "})
      if (const auto at = text.find(before); at != std::string::npos && list.empty())
        list = text.substr(at + 7, text.find_first_of(";(", at) - at - 7);
  }
  std::vector<std::string> values;
  std::istringstream in(list);
  for (std::string value; std::getline(in, value, ',');) {
    value.erase(0, value.find_first_not_of(' '));
    if (!value.empty() && value.find(' ') == std::string::npos) values.push_back(value);
  }
  return values;
}

bool takes_file(const CLI::Option& option) {
  return !is_flag(option) && option.get_type_name().starts_with("TEXT") &&
         values_of(option).empty();
}

std::string long_name(const CLI::Option& option) { return "--" + option.get_lnames().front(); }

std::vector<const CLI::Option*> options_of(const CLI::App& command) {
  return command.get_options([](const CLI::Option* o) { return !o->get_lnames().empty(); });
}

std::vector<const CLI::Option*> positionals_of(const CLI::App& command) {
  return command.get_options([](const CLI::Option* o) { return o->get_positional(); });
}

std::string joined(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

namespace {

void add_names(std::vector<std::string>& names, std::string_view kind) {
  for (const auto& file : rig_config::shipped_files(kind)) names.push_back(file.stem().string());
}

}  // namespace

std::vector<std::string> shipped_names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  if (option.check_lname("protocol"))
    for (const auto& built_in : rig_config::built_in_descriptions())
      names.emplace_back(built_in.name);
  if (!option.get_positional()) return names;
  const std::string name = option.get_name(true);
  using Kind = std::pair<std::string_view, std::string_view>;
  for (const auto& [argument, kind] :
       {Kind{"RIG", rig_config::rigs}, Kind{"VEHICLE", rig_config::vehicles},
        Kind{"GRADE", rig_config::sensors}, Kind{"CAMPAIGN", rig_config::campaigns}})
    if (name == argument) add_names(names, kind);
  if (name == "EXAMPLE" || name == "FILES")
    for (const auto kind : rig_config::kinds_of_files) add_names(names, kind);
  return names;
}

bool takes_list(const CLI::Option& option) {
  return option.get_delimiter() == ',' || option.check_lname("units") ||
         option.check_lname("estimators");
}

RigWords rig_words_of(const CLI::App& command, const CLI::Option& option) {
  const bool is_scorecard = command.get_name() == "scorecard";
  if (is_scorecard && option.check_lname("faults")) return RigWords::faults;
  if (is_scorecard && option.check_lname("also")) return RigWords::pairs;
  if ((is_scorecard && option.check_lname("devices")) || option.check_lname("only") ||
      (command.get_name() == "characterize" && option.check_lname("device")) ||
      (command.get_name() == "topic" && option.get_positional() && option.get_name(true) == "NAME"))
    return RigWords::devices;
  return RigWords::none;
}

}  // namespace drydock::program
