#include <memory>

#include "hil/endurance/emulated_rig.hpp"
#include "hil/endurance/soak.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"
#include "hil/program/options.hpp"

namespace drydock::program {

void add_soak(CLI::App& app, Command& command) {
  struct Arguments {
    std::string rig;
    endurance::SoakOptions options;
  };
  auto arguments = std::make_shared<Arguments>();
  auto& options = arguments->options;
  auto* sub = app.add_subcommand(
      "soak",
      "A rig in virtual time for days under random faults: does anything grow, stick, vanish, "
      "raise a false alarm?");
  sub->footer(
      "Example: drydock soak rig_config/rigs/soak.toml --for 2d --report out\n"
      "         drydock soak rig_config/rigs/soak.toml --for 1d --rest 10min --seed 7\n"
      "         drydock soak rig_config/rigs/demo.toml --for 1d --no-faults");
  sub->add_option("RIG", arguments->rig, "rig file (TOML); emulated lines stand in for real ones")
      ->required();
  sub->add_option("--for", options.duration_s, "virtual time: 10min, 5h, 2d; default 30d")
      ->transform(running_time);
  sub->add_option("--seed", options.seed, "of the sensors' errors and of the faults")
      ->capture_default_str()
      ->check(seed_number);
  auto* none = sub->add_flag("--no-faults{false}", options.faults,
                             "set none: a healthy run, for the number of false alarms");
  sub->add_option("--interval", options.fault_interval_s,
                  "mean time between two faults of one device; default 10min")
      ->transform(duration_text)
      ->excludes(none);
  sub->add_option(
         "--rest", options.rest_s,
         "no fault begins for so long after each five minutes with faults, 10min say: what "
         "is then still found is a false alarm")
      ->transform(duration_text)
      ->excludes(none);
  sub->add_option("--json", options.json, "write summary, faults and troubles to this file");
  sub->add_option("--report", options.report, "write index.html with the memory plot here");
  sub->callback([arguments, &command] {
    command = [arguments] {
      return endurance::soak(endurance::all_emulated(load_rig(arguments->rig)), arguments->options,
                             stdout);
    };
  });
}

}  // namespace drydock::program
