#include <fmt/format.h>

#include <memory>

#include "drivers/cli/decode.hpp"
#include "drivers/cli/replay.hpp"
#include "hil/cli/commands/commands.hpp"

namespace drydock::cli {

namespace {

void add_decode(CLI::App& app, Command& command) {
  auto options = std::make_shared<DecodeOptions>();
  auto* sub =
      app.add_subcommand("decode", "Turn a recording into JSON Lines, one object a message");
  sub->footer(
      "Example: drydock decode --protocol pd0 dive.pd0\n"
      "         drydock decode --protocol can trace.asc\n"
      "         candump -L can0 | drydock decode --protocol nmea2000");
  sub->add_option("FILE", options->file, "recording; default standard input");
  sub->add_option("--protocol", options->protocol, "one of " + decode_protocols())->required();
  sub->add_option("--format", options->format,
                  "the file's format, where its content does not tell: one of " + decode_formats());
  sub->add_flag("--count", options->count, "how many of each type, not the messages");
  sub->add_flag("--quiet", options->quiet, "no line of counts at the end");
  sub->callback(
      [options, &command] { command = [options] { return decode(*options, stdout, stderr); }; });
}

void add_replay(CLI::App& app, Command& command) {
  auto options = std::make_shared<ReplayOptions>();
  auto* sub = app.add_subcommand(
      "replay", "Play a recording through a sensor's driver: its measurements as JSON Lines");
  sub->footer(
      "Example: drydock replay dive.pd0 --protocol pd0\n"
      "         drydock replay can.asc --protocol nmea2000 --kind depth --speed 1");
  sub->add_option("CAPTURE", options->capture, "recording")->required();
  sub->add_option("--protocol", options->protocol, "what the sensor speaks, as in a rig file")
      ->required();
  sub->add_option("--kind", options->kind,
                  "dvl, emlog, gnss, imu, depth, actuator; where several speak the protocol");
  sub->add_option("--speed", options->speed,
                  "max: at once, in virtual time; 1: at the recording's own pace; or a factor")
      ->capture_default_str();
  sub->add_option("--baud", options->baud, "of the recorded line, where the file holds bytes");
  sub->add_option("--format", options->format,
                  "the file's format, where its content does not tell: one of " + decode_formats());
  sub->add_option("--interface", options->interface, "of a CAN capture; default all");
  sub->add_option("--address", options->address, "on the bus; default the first seen");
  sub->add_flag("--quiet", options->quiet, "no states and totals");
  sub->callback(
      [options, &command] { command = [options] { return replay(*options, stdout, stderr); }; });
}

}  // namespace

void add_capture_commands(CLI::App& app, Command& command) {
  add_decode(app, command);
  add_replay(app, command);
}

}  // namespace drydock::cli
