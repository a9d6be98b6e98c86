#include <fmt/format.h>

#include <memory>

#include "hil/program/commands.hpp"
#include "hil/study/run/run_study.hpp"
#include "hil/world/maneuver.hpp"
#include "hil/world/sensor.hpp"
#include "hil/world/sky.hpp"

namespace drydock::program {

namespace {

const CLI::Validator instant_text(
    [](std::string& text) {
      if (world::parse_instant(text)) return std::string{};
      return fmt::format(
          "'{}' is no instant; allowed: 2010-07-01T12:00:00Z (UTC) or '2010-07-01T12:00:00 GPS'",
          text);
    },
    "TIME");
const CLI::Validator place_text(
    [](std::string& text) {
      if (world::parse_place(text)) return std::string{};
      return fmt::format("'{}' is no place; allowed: latitude,longitude[,height] in deg and m",
                         text);
    },
    "LAT,LON,H");

void add_sky(CLI::App& app, Command& command) {
  auto options = std::make_shared<world::SkyOptions>();
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
    command = [options] { return world::show_sky(*options, stdout, stderr); };
  });
}

void add_sensor(CLI::App& app, Command& command) {
  auto options = std::make_shared<world::SensorOptions>();
  auto* sub = app.add_subcommand("sensor", "Allan deviation of an inertial unit of a grade");
  sub->footer(
      "Example: drydock sensor rig_config/sensors/xsens-mti-630.toml --for 5h --allan allan.svg");
  sub->add_option("GRADE", options->grade, "sensor file (TOML) with a table [imu]")->required();
  sub->add_option("--for", options->duration_s, "how long it is recorded: 10min, 5h; default 2h")
      ->transform(duration_text);
  sub->add_option("--rate", options->rate_hz, "samples a second; default the grade's, else 100")
      ->check(CLI::PositiveNumber);
  sub->add_option("--seed", options->seed, "of all random errors")->capture_default_str();
  sub->add_flag("--json", options->json, "JSON instead of a table");
  sub->add_option("--allan", options->allan, "write a plot to this SVG file");
  sub->callback([options, &command] {
    command = [options] { return world::show_sensor(*options, stdout, stderr); };
  });
}

void add_maneuver(CLI::App& app, Command& command) {
  auto options = std::make_shared<world::ManeuverOptions>();
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
    command = [options] { return world::maneuver(*options, stdout, stderr); };
  });
}

void add_study(CLI::App& app, Command& command) {
  auto options = std::make_shared<study::StudyOptions>();
  auto* sub =
      app.add_subcommand("study", "A paper's experiment again: its figures beside ours, many runs");
  sub->footer("Studies: " + study::study_names() +
              "\nExample: drydock study leveling --runs 100 --json leveling.json --report out");
  sub->add_option("NAME", options->name, "which: " + study::study_names())->required();
  sub->add_option("--runs", options->campaign.runs, "of the Monte Carlo experiment")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000}))
      ->capture_default_str();
  sub->add_option("--seed", options->campaign.seed, "of every random number")
      ->capture_default_str();
  sub->add_option("--jobs", options->campaign.jobs,
                  "threads; the result does not depend on it; default one a processor")
      ->check(CLI::Range(1U, 1024U));
  sub->add_option("--cases", options->campaign.cases,
                  "these experiments of the study alone: A,B; velocity has them")
      ->delimiter(',');
  sub->add_option("--ephemeris", options->campaign.ephemeris,
                  "roll: GPS navigation file in place of that of 2010-07-01");
  sub->add_option("--json", options->json, "write the figures to this file");
  sub->add_option("--report", options->report, "write index.html with plots into this folder");
  sub->callback([options, &command] {
    command = [options] { return study::run_study(*options, stdout, stderr); };
  });
}

}  // namespace

void add_world_commands(CLI::App& app, Command& command) {
  add_sensor(app, command);
  add_sky(app, command);
  add_maneuver(app, command);
  add_study(app, command);
}

}  // namespace drydock::program
