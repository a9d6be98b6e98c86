#include <fmt/format.h>

#include <memory>

#include "drivers/bus/configuration.hpp"
#include "drivers/bus/participant.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"

namespace drydock::program {

void add_dds_config(CLI::App& app, Command& command) {
  auto rig = std::make_shared<std::string>();
  auto* sub = app.add_subcommand(
      "dds-config", "What another Cyclone DDS program on this machine needs to hear the bus");
  sub->footer("Example: export CYCLONEDDS_URI=\"$(drydock dds-config)\"");
  sub->add_option("RIG", *rig, "rig file, for its interface; default the loopback interface");
  sub->callback([rig, &command] {
    command = [rig] {
      const auto interface =
          rig->empty() ? std::string(bus::loopback_interface) : load_rig(*rig).dds_interface;
      fmt::print("{}\n", bus::cyclone_configuration(interface));
      return 0;
    };
  });
}

}  // namespace drydock::program
