#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"
#include "hil/program/options.hpp"

#include <memory>

#include "hil/endurance/emulated_rig.hpp"
#include "hil/scorecard/scorecard.hpp"

namespace drydock::program {

void add_scorecard(CLI::App& app, Command& command) {
  struct Arguments {
    std::string rig;
    std::optional<std::uint64_t> seed;
    scorecard::Options options;
  };
  auto a = std::make_shared<Arguments>();
  auto& o = a->options;
  auto* sub = app.add_subcommand(
      "scorecard", "Every fault on every device of a rig: seen when, over when, what it cost");
  sub->footer(
      "Example: drydock scorecard rig_config/rigs/demo.toml --report out\n"
      "         drydock scorecard rig_config/rigs/demo.toml --devices dvl,imu --faults "
      "flip,unplug\n"
      "         drydock scorecard rig_config/rigs/demo.toml --check scorecard.json");
  sub->add_option("RIG", a->rig, "rig file (TOML); emulated lines stand in for real ones")
      ->required();
  auto* devices =
      sub->add_option("--devices", o.devices, "these alone: dvl,imu; default all that are emulated")
          ->delimiter(',');
  auto* faults = sub->add_option("--faults", o.faults,
                                 "these alone: flip,unplug; default all of the vocabulary")
                     ->delimiter(',');
  auto* amount =
      sub->add_option("--amount", o.amount, "times the usual amount of each fault; default 1")
          ->check(CLI::Range(0.001, 1000.0));
  auto* also = sub->add_option("--also", o.also,
                               "DEVICE:FAULT at the same time as each fault of another "
                               "device: emlog:bias");
  sub->add_option("--warm-up", o.window.warm_up_s, "before the fault; default 75s")
      ->transform(duration_text);
  sub->add_option("--fault-for", o.window.fault_s, "how long it lasts; default 30s")
      ->transform(duration_text);
  sub->add_option("--after", o.window.after_s, "behind it; default 45s")->transform(duration_text);
  sub->add_option("--seed", a->seed, "seed of all random errors; default that of the rig file")
      ->check(seed_number);
  sub->add_option("--jobs", o.jobs,
                  "processes; the result does not depend on it; default one a processor")
      ->check(CLI::Range(1U, 1024U));
  sub->add_option("--json", o.json, "write the figures to this file");
  sub->add_option("--report", o.report, "write index.html and heat-map.svg into this folder");
  auto* check = sub->add_option("--check", o.check,
                                "compare with this reference; exit 1 and a line for each figure "
                                "that is not the same");
  sub->add_option("--update-refs", o.update_refs, "write the reference, of all pairs")
      ->excludes(check)
      ->excludes(devices)
      ->excludes(faults)
      ->excludes(amount)
      ->excludes(also);
  sub->callback([a, &command] {
    command = [a] {
      auto rig = endurance::all_emulated(load_rig(a->rig));
      if (a->seed) rig.seed = *a->seed;
      return scorecard::run_scorecard(rig, a->options, stdout, stderr);
    };
  });
}

}  // namespace drydock::program
