#include <memory>

#include "drivers/doctor/doctor.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"

namespace drydock::program {

void add_doctor(CLI::App& app, Command& command) {
  struct Arguments {
    std::string rig;
    bool json = false;
  };
  auto a = std::make_shared<Arguments>();
  auto* sub = app.add_subcommand(
      "doctor", "Is this machine fit for a rig? What is wrong, and the command that mends it");
  sub->footer("Example: drydock doctor rig_config/rigs/bench-serial.toml");
  sub->add_option("RIG", a->rig, "rig file: only what it uses; default the whole machine");
  sub->add_flag("--json", a->json, "one JSON object instead of text");
  sub->callback([a, &command] {
    command = [a] {
      return doctor::doctor(a->rig.empty() ? doctor::Needs{} : doctor::needs_of(load_rig(a->rig)),
                            a->json, stdout);
    };
  });
}

}  // namespace drydock::program
