#include <memory>

#include "hil/endurance/load_run.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"
#include "hil/program/options.hpp"

namespace drydock::program {

void add_load(CLI::App& app, Command& command) {
  struct Arguments {
    std::string rig;
    endurance::LoadOptions options;
  };
  auto a = std::make_shared<Arguments>();
  auto* sub = app.add_subcommand(
      "load", "Whether this machine keeps every deadline of a rig, beside its own timers");
  sub->footer("Example: drydock load rig_config/rigs/forty.toml --for 60s --json load.json");
  sub->add_option("RIG", a->rig, "rig file (TOML); its emulated devices are run")->required();
  sub->add_option("--for", a->options.duration_s, "real time: 60s, 10min; default 10min")
      ->transform(running_time)
      ->check(positive_number);
  sub->add_option("--json", a->options.json, "write figures and verdict to this file");
  sub->callback([a, &command] {
    command = [a] {
      return endurance::load_run(load_rig(a->rig, check::Use::emulation), a->options, stdout,
                                 stderr);
    };
  });
}

}  // namespace drydock::program
