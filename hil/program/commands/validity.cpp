#include <memory>

#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"
#include "hil/program/options.hpp"
#include "hil/validity/run/validity.hpp"

namespace drydock::program {

void add_validity(CLI::App& app, Command& command) {
  struct Arguments {
    std::string rig, speed = "1";
    validity::ValidityOptions options;
  };
  auto a = std::make_shared<Arguments>();
  auto* sub = app.add_subcommand(
      "validity", "How right the times of the measurements are, against the emulated sensors'");
  sub->footer(
      "Example: drydock validity rig_config/rigs/every-protocol.toml --report out\n"
      "         drydock validity rig_config/rigs/every-protocol.toml --bauds --for 20s");
  sub->add_option("RIG", a->rig, "rig file (TOML); its emulated devices are looked at")->required();
  sub->add_option("--for", a->options.duration_s, "how long a run takes; default 30s")
      ->transform(running_time);
  sub->add_option("--speed", a->speed, "1: real time; max: lockstep in virtual time")
      ->check(CLI::IsMember({"1", "max"}))
      ->capture_default_str();
  sub->add_flag("--bauds", a->options.bauds,
                "the serial devices at every baud rate from 4800 to 921600, a run each");
  sub->add_option("--json", a->options.json, "write the figures to this file");
  sub->add_option("--report", a->options.report, "write index.html with plots into this folder");
  sub->callback([a, &command] {
    command = [a] {
      a->options.lockstep = a->speed == "max";
      const auto use = a->options.lockstep ? check::Use::any : check::Use::emulation;
      return validity::measure_validity(load_rig(a->rig, use), a->options);
    };
  });
}

}  // namespace drydock::program
