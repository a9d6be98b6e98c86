#include <memory>

#include "hil/program/commands.hpp"
#include "hil/program/options.hpp"
#include "hil/world/maneuver.hpp"
#include "rig_config/shipped.hpp"

namespace drydock::program {

void add_maneuver(CLI::App& app, Command& command) {
  auto options = std::make_shared<world::ManeuverOptions>();
  auto* sub = app.add_subcommand("maneuver", "Standard manoeuvres of a vehicle, and their figures");
  sub->footer(
      "Example: drydock maneuver rig_config/vehicles/nps-auv-ii.toml turning-circle --plot "
      "circle.svg\n"
      "         drydock maneuver rig_config/vehicles/nps-auv-ii.toml --schedule s.csv --csv "
      "out.csv");
  sub->add_option("VEHICLE", options->vehicle, "vehicle file (TOML), or the name of a shipped one")
      ->required();
  auto* kind = sub->add_option("MANEUVER", options->kind, "turning-circle, zigzag, spiral or dive")
                   ->check(CLI::IsMember({"turning-circle", "zigzag", "spiral", "dive"}));
  auto* schedule =
      sub->add_option("--schedule", options->schedule,
                      "CSV t,rudder,stern,bow,rpm (s, deg, revolutions a minute) in place of the "
                      "manoeuvre's own commands; each row holds until the next");
  sub->add_option(
         "--speed", options->speed_mps,
         "m/s at the start and commanded; default that of 1500 rpm, or the schedule's first")
      ->check(positive_number);
  sub->add_option(
         "--deflection", options->deflection_deg,
         "of rudder or stern planes, deg; default: turning circle and spiral to the stops, "
         "zigzag 10, dive 5")
      ->excludes(schedule);
  sub->add_option("--switch", options->switch_deg,
                  "change of heading (zigzag) or pitch (dive) that reverses, deg; default 10")
      ->check(positive_number)
      ->excludes(schedule);
  sub->add_option("--for", options->duration_s,
                  "how long a schedule is sailed; default 300 s behind its last row")
      ->needs(schedule)
      ->transform(running_time);
  sub->add_flag("--ideal-actuators", options->ideal_actuators,
                "rudder, planes and propeller without lag and rate limits");
  sub->add_flag("--json", options->json, "figures as JSON");
  sub->add_option("--csv", options->csv, "write the track here, 10 Hz: SI, radians, z down");
  sub->add_option("--plot", options->plot, "write a plot to this SVG file");
  sub->callback([=, &command] {
    if (kind->empty() && schedule->empty())
      throw CLI::ValidationError(
          "MANEUVER", "which? turning-circle, zigzag, spiral or dive; or --schedule FILE");
    options->vehicle = rig_config::find_shipped(options->vehicle, rig_config::vehicles);
    command = [options] { return world::maneuver(*options, stdout, stderr); };
  });
}

}  // namespace drydock::program
