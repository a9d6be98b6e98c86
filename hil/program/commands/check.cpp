#include <memory>

#include "hil/check/check.hpp"
#include "hil/program/commands.hpp"
#include "rig_config/shipped.hpp"

namespace drydock::program {

namespace {

std::string find_of_any_kind(const std::string& word) {
  for (const auto kind :
       {rig_config::rigs, rig_config::missions, rig_config::sensors, rig_config::vehicles})
    if (auto file = rig_config::find_shipped(word, kind); file != word) return file;
  return word;
}

}  // namespace

void add_check(CLI::App& app, Command& command) {
  auto files = std::make_shared<std::vector<std::string>>();
  auto* sub = app.add_subcommand(
      "check", "Check rig, mission, sensor, device and vehicle files, and DBC files");
  sub->footer("Example: drydock check rig_config/rigs/*.toml");
  sub->add_option("FILES", *files, "TOML files, and DBC files (*.dbc)")->required();
  sub->callback([files, &command] {
    for (auto& file : *files) file = find_of_any_kind(file);
    command = [files] { return check::check(*files, stdout); };
  });
}

}  // namespace drydock::program
