#include <memory>

#include "hil/check/check.hpp"
#include "hil/program/commands.hpp"

namespace drydock::program {

void add_check(CLI::App& app, Command& command) {
  auto files = std::make_shared<std::vector<std::string>>();
  auto* sub = app.add_subcommand("check", "Check rig, mission, sensor and vehicle files");
  sub->footer("Example: drydock check rig_config/rigs/*.toml");
  sub->add_option("FILES", *files, "TOML files")->required();
  sub->callback([files, &command] { command = [files] { return check::check(*files, stdout); }; });
}

}  // namespace drydock::program
