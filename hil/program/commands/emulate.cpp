#include <memory>

#include "hil/bench/emulate.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"
#include "hil/program/options.hpp"

namespace drydock::program {

void add_emulate(CLI::App& app, Command& command) {
  struct Arguments {
    std::string rig, faults;
    double duration_s = 0;
    RealtimeOptions realtime;
  };
  auto a = std::make_shared<Arguments>();
  auto* sub =
      app.add_subcommand("emulate", "The emulated devices of a rig, for any program to open");
  sub->footer("Example: drydock emulate rig_config/rigs/demo.toml");
  sub->add_option("RIG", a->rig, "rig file (TOML)")->required();
  sub->add_option("--for", a->duration_s, "how long: 60s, 10min, 5.5h; default until Ctrl-C")
      ->transform(running_time);
  add_faults_option(*sub, a->faults);
  add_realtime(*sub, a->realtime);
  sub->callback([a, &command] {
    command = [a] {
      auto rig = load_rig(a->rig, check::Use::emulation);
      add_faults(rig, a->faults);
      claim(a->realtime);
      return bench::emulate(rig, a->duration_s);
    };
  });
}

}  // namespace drydock::program
