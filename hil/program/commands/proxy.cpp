#include <memory>

#include "drivers/decode/decode.hpp"

#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"
#include "hil/program/options.hpp"
#include "hil/proxy/run_proxy.hpp"

namespace drydock::program {

void add_proxy(CLI::App& app, Command& command) {
  auto options = std::make_shared<proxy::ProxyCommandOptions>();
  auto* sub = app.add_subcommand(
      "proxy", "Pass a real device's link on to a virtual one, with faults between");
  sub->footer(
      "Example: drydock proxy 'serial:/dev/ttyUSB0?baud=115200' pty:dvl --protocol pd0 --device "
      "dvl "
      "--faults F.toml\n"
      "         drydock proxy socketcan:can0 socketcan:vcan0 --for 10min --json\n"
      "         drydock proxy tcp:192.168.194.95:1037 tcp:localhost:1037");
  sub->add_option("REAL", options->real, "link URI of the device, opened as its driver does")
      ->required();
  sub->add_option(
         "VIRTUAL", options->virt,
         "link URI where drivers find it: pty, tcp, udp; socketcan (vcan), slcan, can:auto")
      ->required();
  sub->add_option("--faults", options->faults, "file of blocks [[fault]], docs/use/faults.md");
  sub->add_option("--protocol", options->protocol,
                  "what the device speaks; faults of messages need it: one of " +
                      decode::decode_protocols() + "; or a description");
  sub->add_option("--device", options->device, "the name by which the faults call it")
      ->capture_default_str();
  sub->add_option("--address", options->address,
                  "of the device on a bus: only its frames suffer; default those of every one that "
                  "speaks the protocol");
  sub->add_option("--seed", options->seed, "of the faults' chances")
      ->capture_default_str()
      ->check(seed_number);
  sub->add_option("--for", options->duration_s, "how long: 60s, 10min; default until Ctrl-C")
      ->transform(running_time);
  sub->add_flag("--json", options->json, "the summary as one JSON object");
  sub->callback([options, &command] {
    command = [options] {
      options->description = load_protocol(options->protocol);
      return proxy::proxy(*options, stdout, stderr);
    };
  });
}

}  // namespace drydock::program
