#include <memory>

#include "hil/campaign/plan/campaign_file.hpp"
#include "hil/check/check.hpp"
#include "hil/program/commands.hpp"
#include "rig_config/shipped.hpp"
#include "rig_config/toml/checked_file.hpp"
#include "rig_config/toml/toml_reader.hpp"

namespace drydock::program {

namespace {

std::string find_of_any_kind(const std::string& word) {
  for (const auto kind : rig_config::kinds_of_files)
    if (auto file = rig_config::find_shipped(word, kind); file != word) return file;
  return word;
}

/// Campaigns are no concern of a bench, so its checks do not know them.
std::optional<rig_config::Problems> check_campaign(const std::string& file) {
  const auto text = rig_config::read_file(file);
  if (!text) return {};
  const auto root = rig_config::read_toml(*text, file);
  if (!root || !root->find("campaign")) return {};
  const auto campaign = campaign::load_campaign(file);
  return campaign ? rig_config::Problems{} : campaign.error();
}

}  // namespace

void add_check(CLI::App& app, Command& command) {
  auto files = std::make_shared<std::vector<std::string>>();
  auto* sub = app.add_subcommand(
      "check", "Check rig, mission, sensor, device, vehicle and campaign files, and DBC files");
  sub->footer("Example: drydock check rig_config/rigs/*.toml");
  sub->add_option("FILES", *files, "TOML files, and DBC files (*.dbc)")->required();
  sub->callback([files, &command] {
    for (auto& file : *files) file = find_of_any_kind(file);
    command = [files] { return check::check(*files, stdout, check_campaign); };
  });
}

}  // namespace drydock::program
