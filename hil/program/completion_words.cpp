#include "hil/program/completion_words.hpp"

#include <fmt/format.h>

#include <array>
#include <sstream>

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
  } else if (const auto one_of = text.find("one of "); one_of != std::string::npos) {
    list = text.substr(one_of + 7, text.find_first_of(";(", one_of) - one_of - 7);
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

std::vector<std::string> shipped_names_of(const CLI::Option& positional) {
  using Kind = std::pair<std::string_view, std::string_view>;
  static constexpr std::array kinds{Kind{"RIG", rig_config::rigs},
                                    Kind{"VEHICLE", rig_config::vehicles},
                                    Kind{"GRADE", rig_config::sensors}};
  std::vector<std::string> names;
  for (const auto& [name, kind] : kinds)
    if (positional.get_name(true) == name)
      for (const auto& file : rig_config::shipped_files(kind))
        names.push_back(file.stem().string());
  return names;
}

}  // namespace drydock::program
