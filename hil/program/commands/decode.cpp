#include <memory>

#include "drivers/decode/decode.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"

namespace drydock::program {

void add_decode(CLI::App& app, Command& command) {
  auto options = std::make_shared<decode::DecodeOptions>();
  auto* sub =
      app.add_subcommand("decode", "Turn a recording into JSON Lines, one object a message");
  sub->footer(
      "Example: drydock decode --protocol pd0 dive.pd0\n"
      "         drydock decode --protocol can trace.asc\n"
      "         drydock decode --dbc imu.dbc can.log\n"
      "         drydock decode --pgns canboat.json can.log\n"
      "         candump -L can0 | drydock decode --protocol nmea2000");
  sub->add_option("FILE", options->file, "recording; default standard input");
  auto* protocol = sub->add_option(
      "--protocol", options->protocol,
      "one of " + decode::decode_protocols() + "; or a description: valeport-vat.toml");
  auto* dbc = sub->add_option("--dbc", options->dbc,
                              "a DBC file that describes the messages of a CAN capture");
  dbc->excludes(protocol);
  sub->add_option("--pgns", options->pgns,
                  "a table of PGNs (canboat.json) for an NMEA 2000 capture")
      ->excludes(protocol)
      ->excludes(dbc);
  sub->add_option(
      "--format", options->format,
      "the file's format, where its content does not tell: one of " + decode::decode_formats());
  sub->add_option("--interface", options->interface,
                  "of a pcapng file with several serial lines; default the only one");
  sub->add_flag("--count", options->count, "how many of each type, not the messages");
  sub->add_flag("--quiet", options->quiet, "no line of counts at the end");
  sub->callback([options, &command] {
    command = [options] {
      options->description = load_protocol(options->protocol);
      return decode::decode(*options, stdout, stderr);
    };
  });
}

}  // namespace drydock::program
