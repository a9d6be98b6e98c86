#include <memory>

#include "estimators/host/estimate.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"
#include "hil/program/options.hpp"

namespace drydock::program {

void add_estimate(CLI::App& app, Command& command) {
  struct Arguments {
    std::string rig;
    host::EstimateOptions options;
  };
  auto a = std::make_shared<Arguments>();
  auto* sub = app.add_subcommand("estimate", "Estimators of a rig on the measurements of the bus");
  sub->footer(
      "Example, in three terminals: drydock emulate R.toml; drydock drive R.toml; drydock estimate "
      "R.toml");
  sub->add_option("RIG", a->rig, "rig file (TOML)")->required();
  sub->add_option("--for", a->options.duration_s,
                  "how long: 60s, 10min, 5.5h; default until Ctrl-C")
      ->transform(running_time);
  sub->add_flag("--json", a->options.json_lines, "every estimate as a JSON line");
  sub->callback(
      [a, &command] { command = [a] { return host::estimate(load_rig(a->rig), a->options); }; });
}

}  // namespace drydock::program
