#include <memory>

#include "drivers/decode/decode.hpp"
#include "hil/characterize/report/characterize.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"
#include "hil/program/options.hpp"

namespace drydock::program {

void add_characterize(CLI::App& app, Command& command) {
  auto options = std::make_shared<characterize::CharacterizeOptions>();
  auto* sub = app.add_subcommand(
      "characterize",
      "What a sensor is worth: noise, steps, rate, latency, dropouts, beside its "
      "data sheet");
  sub->footer(
      "Example: drydock characterize dive.mcap --device imu --report out -o my-imu.toml\n"
      "         drydock characterize bench.toml --device imu --for 2h --json imu.json\n"
      "         drydock characterize can.asc --protocol xsens");
  sub->add_option("SOURCE", options->source,
                  "recording (.mcap), rig file (.toml), or a capture of one sensor")
      ->required();
  sub->add_option("--device", options->device, "by name; default every one");
  sub->add_option("--reference", options->reference,
                  "device to compare with; default GNSS for DVL and IMU, DVL for EM log");
  sub->add_option(
      "--grade", options->grade,
      "sensor file to stand beside it; default the rig's, else the nearest shipped one");
  sub->add_option("--for", options->duration_s,
                  "how long a rig runs: default 1h where all links are emulated, else 60s")
      ->transform(running_time);
  sub->add_option("--protocol", options->capture.protocol,
                  "of a capture: one of " + decode::decode_protocols() +
                      "; or a description: valeport-vat.toml");
  sub->add_option("--kind", options->capture.kind,
                  "of a capture's sensor, where several speak the protocol");
  sub->add_option("--baud", options->capture.baud, "of a capture's line, where it holds bytes");
  sub->add_option(
      "--format", options->capture.format,
      "of a capture, where its content does not tell: one of " + decode::decode_formats());
  sub->add_option("--interface", options->capture.interface, "of a CAN capture; default all");
  sub->add_option("--address", options->capture.address, "on the bus; default the first seen");
  sub->add_option("--json", options->json, "write the figures to this file");
  sub->add_option("--report", options->report, "write index.html with plots into this folder");
  sub->add_option("-o,--out", options->out, "write a sensor file for the emulator");
  sub->callback([options, &command] {
    command = [options] {
      options->capture.description = load_protocol(options->capture.protocol);
      return characterize::characterize_source(*options, stdout, stderr);
    };
  });
}

}  // namespace drydock::program
