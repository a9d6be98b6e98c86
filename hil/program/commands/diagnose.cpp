#include "hil/diagnose/diagnose.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <stdexcept>

#include "drivers/shell/rig_devices.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "hil/diagnose/sources.hpp"
#include "hil/program/capture_arguments.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/link_argument.hpp"
#include "hil/program/load_rig.hpp"
#include "hil/program/options.hpp"
#include "hil/replay/replay_rig.hpp"

namespace drydock::program {

namespace {

struct DiagnoseArguments {
  std::string source;
  double duration_s = 120;
  unsigned baud = 0;
  diagnose::DiagnoseOptions options;
};

diagnose::Outcome examine_rig(const DiagnoseArguments& a) {
  const auto rig = load_rig(a.source);
  auto devices = shell::make_devices(rig);
  if (!devices) throw std::runtime_error(devices.error().message);
  return diagnose::listen_to(rig, std::move(*devices), a.source, a.duration_s);
}

/// A rig file ends with .toml, a recording tells itself by its content, any other file is a
/// capture, and what is no file is a link.
diagnose::Outcome examine(const DiagnoseArguments& a) {
  if (names_rig(a.source)) return examine_rig(a);
  const bool is_path = a.source.find('/') != std::string::npos || a.source.ends_with(".mcap") ||
                       std::filesystem::is_directory(a.source);
  if (is_path && a.source.find(':') == std::string::npos) must_be_readable(a.source);
  if (!std::filesystem::is_regular_file(a.source)) {
    must_name_link("diagnose", a.source);
    return diagnose::listen_to_link(a.source, a.duration_s);
  }
  return replay::is_recording(a.source) ? diagnose::read_recording(a.source)
                                        : diagnose::read_capture(a.source, a.baud);
}

}  // namespace

void add_diagnose(CLI::App& app, Command& command) {
  auto a = std::make_shared<DiagnoseArguments>();
  auto* sub = app.add_subcommand(
      "diagnose", "Say what is wrong with which sensor, since when, why, and what to try");
  sub->footer(
      "Example: drydock diagnose rig_config/rigs/bench-serial.toml --for 1min\n"
      "         drydock diagnose dive.mcap --report out\n"
      "         drydock diagnose dive.pd0 --baud 115200\n"
      "         drydock diagnose serial:/dev/ttyUSB0\n"
      "Exit code: 0 nothing found, 1 something found, a sensor not heard or "
      "the source not readable, 2 wrong usage");
  sub->add_option("SOURCE", a->source,
                  "rig file (TOML), recording (MCAP), capture of one link, or link URI")
      ->required();
  sub->add_option("--for", a->duration_s,
                  "how long it listens to a rig or link: 30s, 10min; default 2min")
      ->transform(running_time);
  sub->add_option("--baud", a->baud, "of the recorded line, for a capture of bytes; default 9600");
  sub->add_option("--report", a->options.report,
                  "write index.html with a plot for each finding into this folder");
  sub->add_flag("--json", a->options.json, "one JSON object instead of text");
  sub->callback([a, &command] {
    command = [a] {
      try {
        return diagnose::tell(examine(*a), a->options, stdout);
      } catch (const std::exception& error) {
        fmt::print(stderr, "diagnose: {}\n", error.what());
        return terminal::exit_failed;
      }
    };
  });
}

}  // namespace drydock::program
