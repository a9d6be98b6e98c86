#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <stdexcept>

#include "drivers/cli/check.hpp"
#include "drivers/cli/decode.hpp"
#include "drivers/cli/drive.hpp"
#include "drivers/cli/monitor.hpp"
#include "drivers/cli/replay.hpp"
#include "estimators/cli/estimate.hpp"
#include "hil/cli/duration.hpp"
#include "hil/cli/emulate.hpp"
#include "hil/cli/maneuver.hpp"
#include "hil/cli/run.hpp"
#include "hil/cli/sky.hpp"
#include "hil/cli/study.hpp"
#include "rig_config/load.hpp"

namespace {

using namespace drydock;

constexpr int exit_failed = 1;
constexpr int exit_usage = 2;

/// A rig file that cannot be used; the lines have been printed.
struct BadRig {};

/// ROS_DOMAIN_ID chooses the DDS domain, as for every ROS 2 program, and goes before the rig file.
void apply_environment(rig_config::Rig& rig) {
  const char* text = std::getenv("ROS_DOMAIN_ID");
  if (text == nullptr || *text == '\0') return;
  constexpr int highest_domain = 232;
  const std::string_view digits(text);
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), rig.dds_domain);
  if (error != std::errc{} || end != digits.data() + digits.size() || rig.dds_domain < 0 ||
      rig.dds_domain > highest_domain) {
    throw std::runtime_error(
        fmt::format("ROS_DOMAIN_ID is '{}'; allowed: 0 to {}", digits, highest_domain));
  }
}

rig_config::Rig load(const std::string& path) {
  auto rig = rig_config::load_rig(path, cli::load_options());
  if (rig) {
    apply_environment(*rig);
    return std::move(*rig);
  }
  for (const auto& problem : rig.error()) fmt::print(stderr, "{}\n", to_string(problem));
  throw BadRig{};
}

const CLI::Validator duration_text(
    [](std::string& text) {
      const auto seconds = cli::parse_duration(text);
      if (!seconds) return fmt::format("'{}' is no duration; allowed: 90, 60s, 10min, 5.5h", text);
      text = fmt::format("{}", *seconds);
      return std::string{};
    },
    "DURATION");

/// What the command line chose: set by exactly one subcommand's callback.
using Command = std::function<int()>;

void add_run(CLI::App& app, Command& command) {
  struct Arguments {
    std::string rig, speed = "1";
    std::optional<std::uint64_t> seed;
    cli::RunOptions options;
  };
  auto a = std::make_shared<Arguments>();
  auto* sub =
      app.add_subcommand("run", "Emulated devices, drivers and estimators of a rig, with a report");
  sub->footer(
      "Example: drydock run rig_config/rigs/demo.toml --for 60s --report out\n"
      "         drydock run rig_config/rigs/demo.toml --for 10min --speed max --json out.json");
  sub->add_option("RIG", a->rig, "rig file (TOML)")->required();
  sub->add_option("--for", a->options.duration_s,
                  "how long: 60s, 10min, 5.5h; default until Ctrl-C")
      ->transform(duration_text);
  sub->add_option("--seed", a->seed, "seed of all random errors; default that of the rig file");
  sub->add_option("--speed", a->speed, "1: real time; max: lockstep in virtual time")
      ->check(CLI::IsMember({"1", "max"}))
      ->capture_default_str();
  sub->add_option("--json", a->options.json, "write the summary to this file");
  sub->add_option("--report", a->options.report, "write index.html with plots into this folder");
  sub->add_flag("--expect-streaming", a->options.expect_streaming,
                "exit 1 when a device is not streaming at the end");
  sub->add_option(
      "--expect-rms", a->options.expect_rms_deg,
      "exit 1 when an attitude estimate is worse than this against the truth [deg RMS]");
  sub->callback([a, &command] {
    command = [a] {
      auto rig = load(a->rig);
      if (a->seed) rig.seed = *a->seed;
      a->options.lockstep = a->speed == "max";
      return cli::run(rig, a->options);
    };
  });
}

/// emulate, drive: a rig and a duration.
void add_rig_command(CLI::App& app, Command& command, const std::string& name,
                     const std::string& description, const std::string& example,
                     int (*body)(const rig_config::Rig&, double)) {
  struct Arguments {
    std::string rig;
    double duration_s = 0;
  };
  auto a = std::make_shared<Arguments>();
  auto* sub = app.add_subcommand(name, description);
  sub->footer("Example: " + example);
  sub->add_option("RIG", a->rig, "rig file (TOML)")->required();
  sub->add_option("--for", a->duration_s, "how long: 60s, 10min, 5.5h; default until Ctrl-C")
      ->transform(duration_text);
  sub->callback(
      [a, &command, body] { command = [a, body] { return body(load(a->rig), a->duration_s); }; });
}

void add_estimate(CLI::App& app, Command& command) {
  struct Arguments {
    std::string rig;
    cli::EstimateOptions options;
  };
  auto a = std::make_shared<Arguments>();
  auto* sub = app.add_subcommand("estimate", "Estimators of a rig on the measurements of the bus");
  sub->footer(
      "Example, in three terminals: drydock emulate R.toml; drydock drive R.toml; drydock estimate "
      "R.toml");
  sub->add_option("RIG", a->rig, "rig file (TOML)")->required();
  sub->add_option("--for", a->options.duration_s,
                  "how long: 60s, 10min, 5.5h; default until Ctrl-C")
      ->transform(duration_text);
  sub->add_flag("--json", a->options.json_lines, "every estimate as a JSON line");
  sub->callback(
      [a, &command] { command = [a] { return cli::estimate(load(a->rig), a->options); }; });
}

void add_check(CLI::App& app, Command& command) {
  auto files = std::make_shared<std::vector<std::string>>();
  auto* sub = app.add_subcommand("check", "Check rig, mission, sensor and vehicle files");
  sub->footer("Example: drydock check rig_config/rigs/*.toml");
  sub->add_option("FILES", *files, "TOML files")->required();
  sub->callback([files, &command] { command = [files] { return cli::check(*files, stdout); }; });
}

void add_monitor(CLI::App& app, Command& command) {
  auto options = std::make_shared<cli::MonitorOptions>();
  auto* sub = app.add_subcommand("monitor", "Print what a link says; never writes to the wire");
  sub->footer("Example: drydock monitor 'serial:/dev/ttyUSB0?baud=38400' --protocol ubx");
  sub->add_option("LINK", options->link, "link URI")->required();
  sub->add_option("--protocol", options->protocol, "one of " + cli::decode_protocols())->required();
  sub->add_option("--for", options->duration_s, "how long: 60s, 10min; default until Ctrl-C")
      ->transform(duration_text);
  sub->callback([options, &command] { command = [options] { return cli::monitor(*options); }; });
}

void add_decode(CLI::App& app, Command& command) {
  auto options = std::make_shared<cli::DecodeOptions>();
  auto* sub =
      app.add_subcommand("decode", "Turn a recording into JSON Lines, one object a message");
  sub->footer(
      "Example: drydock decode --protocol pd0 dive.pd0\n"
      "         drydock decode --protocol can trace.asc\n"
      "         candump -L can0 | drydock decode --protocol nmea2000");
  sub->add_option("FILE", options->file, "recording; default standard input");
  sub->add_option("--protocol", options->protocol, "one of " + cli::decode_protocols())->required();
  sub->add_option(
      "--format", options->format,
      "the file's format, where its content does not tell: one of " + cli::decode_formats());
  sub->add_flag("--count", options->count, "how many of each type, not the messages");
  sub->add_flag("--quiet", options->quiet, "no line of counts at the end");
  sub->callback([options, &command] {
    command = [options] { return cli::decode(*options, stdout, stderr); };
  });
}

void add_replay(CLI::App& app, Command& command) {
  auto options = std::make_shared<cli::ReplayOptions>();
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
  sub->add_option(
      "--format", options->format,
      "the file's format, where its content does not tell: one of " + cli::decode_formats());
  sub->add_option("--interface", options->interface, "of a CAN capture; default all");
  sub->add_option("--address", options->address, "on the bus; default the first seen");
  sub->add_flag("--quiet", options->quiet, "no states and totals");
  sub->callback([options, &command] {
    command = [options] { return cli::replay(*options, stdout, stderr); };
  });
}

const CLI::Validator instant_text(
    [](std::string& text) {
      if (cli::parse_instant(text)) return std::string{};
      return fmt::format(
          "'{}' is no instant; allowed: 2010-07-01T12:00:00Z (UTC) or '2010-07-01T12:00:00 GPS'",
          text);
    },
    "TIME");
const CLI::Validator place_text(
    [](std::string& text) {
      if (cli::parse_place(text)) return std::string{};
      return fmt::format("'{}' is no place; allowed: latitude,longitude[,height] in deg and m",
                         text);
    },
    "LAT,LON,H");

void add_sky(CLI::App& app, Command& command) {
  auto options = std::make_shared<cli::SkyOptions>();
  auto* sub = app.add_subcommand("sky", "GPS satellites of a broadcast ephemeris at one instant");
  sub->footer(
      "Example: drydock sky --ephemeris fixtures/rinex/walker.rnx --at 2026-11-21T09:00:00Z \\\n"
      "                     --from 36.0,129.0,0 --plot sky.svg");
  sub->add_option("--ephemeris", options->ephemeris, "RINEX 2 or 3 GPS navigation file")
      ->required();
  sub->add_option("--at", options->at,
                  "2010-07-01T12:00:00Z (UTC; also without Z) or '2010-07-01T12:00:00 GPS'")
      ->required()
      ->check(instant_text);
  auto* from = sub->add_option("--from", options->from,
                               "latitude and longitude in deg, height over the ellipsoid in m: "
                               "elevation, azimuth and range from there")
                   ->check(place_text);
  sub->add_flag("--json", options->json, "JSON instead of a table");
  sub->add_option("--plot", options->plot, "write a sky plot to this SVG file")->needs(from);
  sub->callback([options, &command] {
    command = [options] { return cli::show_sky(*options, stdout, stderr); };
  });
}

void add_maneuver(CLI::App& app, Command& command) {
  auto options = std::make_shared<cli::ManeuverOptions>();
  auto* sub = app.add_subcommand("maneuver", "Standard manoeuvres of a vehicle, and their figures");
  sub->footer(
      "Example: drydock maneuver rig_config/vehicles/nps-auv-ii.toml turning-circle --plot "
      "circle.svg\n"
      "         drydock maneuver rig_config/vehicles/nps-auv-ii.toml --schedule s.csv --csv "
      "out.csv");
  sub->add_option("VEHICLE", options->vehicle, "vehicle file (TOML)")->required();
  auto* kind = sub->add_option("MANEUVER", options->kind, "turning-circle, zigzag, spiral or dive")
                   ->check(CLI::IsMember({"turning-circle", "zigzag", "spiral", "dive"}));
  auto* schedule =
      sub->add_option("--schedule", options->schedule,
                      "CSV t,rudder,stern,bow,rpm (s, deg, revolutions a minute) in place of the "
                      "manoeuvre's own commands; each row holds until the next");
  sub->add_option(
         "--speed", options->speed_mps,
         "m/s at the start and commanded; default that of 1500 rpm, or the schedule's first")
      ->check(CLI::PositiveNumber);
  sub->add_option(
         "--deflection", options->deflection_deg,
         "of rudder or stern planes, deg; default: turning circle and spiral to the stops, "
         "zigzag 10, dive 5")
      ->excludes(schedule);
  sub->add_option("--switch", options->switch_deg,
                  "change of heading (zigzag) or pitch (dive) that reverses, deg; default 10")
      ->check(CLI::PositiveNumber)
      ->excludes(schedule);
  sub->add_option("--for", options->duration_s,
                  "how long a schedule is sailed; default 300 s behind its last row")
      ->needs(schedule)
      ->transform(duration_text);
  sub->add_flag("--ideal-actuators", options->ideal_actuators,
                "rudder, planes and propeller without lag and rate limits");
  sub->add_flag("--json", options->json, "figures as JSON");
  sub->add_option("--csv", options->csv, "write the track here, 10 Hz: SI, radians, z down");
  sub->add_option("--plot", options->plot, "write a plot to this SVG file");
  sub->callback([=, &command] {
    if (kind->empty() && schedule->empty())
      throw CLI::ValidationError("MANEUVER", "a manoeuvre or --schedule is needed");
    command = [options] { return cli::maneuver(*options, stdout, stderr); };
  });
}

void add_study(CLI::App& app, Command& command) {
  auto options = std::make_shared<cli::StudyOptions>();
  auto* sub =
      app.add_subcommand("study", "A paper's experiment again: its figures beside ours, many runs");
  sub->footer("Studies: " + cli::study_names() +
              "\nExample: drydock study leveling --runs 100 --json leveling.json --report out");
  sub->add_option("NAME", options->name, "which: " + cli::study_names())->required();
  sub->add_option("--runs", options->campaign.runs, "of the Monte Carlo experiment")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000}))
      ->capture_default_str();
  sub->add_option("--seed", options->campaign.seed, "of every random number")
      ->capture_default_str();
  sub->add_option("--jobs", options->campaign.jobs,
                  "threads; the result does not depend on it; default one a processor")
      ->check(CLI::Range(1U, 1024U));
  sub->add_option("--json", options->json, "write the figures to this file");
  sub->add_option("--report", options->report, "write index.html with plots into this folder");
  sub->callback([options, &command] {
    command = [options] { return cli::run_study(*options, stdout, stderr); };
  });
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Drydock: a test rig for underwater navigation.\n"
      "Exit codes: 0 success, 1 the run or the input failed, 2 wrong usage or configuration."};
  app.name("drydock");
  app.set_version_flag("--version", DRYDOCK_VERSION);
  app.require_subcommand(1);
  app.footer("drydock COMMAND --help shows an example of each.");
  Command command;
  add_run(app, command);
  add_rig_command(app, command, "emulate", "The emulated devices of a rig, for any program to open",
                  "drydock emulate rig_config/rigs/demo.toml", cli::emulate);
  add_rig_command(app, command, "drive", "The drivers of a rig: links in, measurements on the bus",
                  "drydock drive rig_config/rigs/demo.toml", cli::drive);
  add_estimate(app, command);
  add_check(app, command);
  add_monitor(app, command);
  add_decode(app, command);
  add_replay(app, command);
  add_sky(app, command);
  add_maneuver(app, command);
  add_study(app, command);
  try {
    app.parse(argc, argv);
    return command();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : exit_usage;
  } catch (const BadRig&) {
    return exit_usage;
  } catch (const std::exception& error) {
    fmt::print(stderr, "drydock: {}\n", error.what());
    return exit_failed;
  }
}
