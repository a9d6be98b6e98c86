#include <memory>

#include "hil/control/order_faults.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"
#include "hil/program/options.hpp"

namespace drydock::program {

namespace {

struct FaultArguments {
  std::string rig;
  control::FaultOptions options;
};

using Body = int (*)(const rig_config::Rig&, const control::FaultOptions&);

CLI::App* add_action(CLI::App* fault, const std::shared_ptr<FaultArguments>& a, Command& command,
                     const std::string& name, const std::string& description, Body body) {
  auto* sub = fault->add_subcommand(name, description);
  sub->add_flag("--json", a->options.json, "one JSON object instead of text");
  sub->callback(
      [a, &command, body] { command = [a, body] { return body(load_rig(a->rig), a->options); }; });
  return sub;
}

}  // namespace

void add_fault(CLI::App& app, Command& command) {
  auto a = std::make_shared<FaultArguments>();
  auto* fault = app.add_subcommand("fault", "Break a running bench on purpose, and mend it again");
  fault->footer(
      "Example: drydock fault rig_config/rigs/demo.toml set dvl garbage --for 5s\n"
      "         drydock fault rig_config/rigs/demo.toml set imu bias rate_degps=0.5,0,0\n"
      "         drydock fault rig_config/rigs/demo.toml clear dvl\n"
      "         drydock fault rig_config/rigs/demo.toml words");
  fault->add_option("RIG", a->rig, "rig file (TOML) of a bench that runs: drydock run or emulate")
      ->required();
  fault->require_subcommand(1);

  auto* set =
      add_action(fault, a, command, "set", "from now on a device has a fault", control::set_fault);
  set->add_option("DEVICE", a->options.device, "name in the rig file")->required();
  set->add_option("FAULT", a->options.fault, "a word that `words` lists")->required();
  set->add_option("KEY=VALUE", a->options.pairs, "how strong, as in a fault file");
  set->add_option("--for", a->options.for_s, "how long: 5s, 1min; default until cleared")
      ->transform(running_time);

  auto* clear = add_action(fault, a, command, "clear", "takes faults away, those of files as well",
                           control::clear_faults);
  clear->add_option("DEVICE", a->options.device, "default: all");
  clear->add_option("FAULT", a->options.fault, "default: all of the device");

  add_action(fault, a, command, "list", "what is in force now", control::list_faults);
  add_action(fault, a, command, "words", "which faults each device can have",
             control::show_fault_words);
}

}  // namespace drydock::program
