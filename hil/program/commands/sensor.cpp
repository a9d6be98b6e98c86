#include <memory>

#include "hil/program/commands.hpp"
#include "hil/program/options.hpp"
#include "hil/world/sensor.hpp"
#include "rig_config/shipped.hpp"

namespace drydock::program {

void add_sensor(CLI::App& app, Command& command) {
  auto options = std::make_shared<world::SensorOptions>();
  auto* sub = app.add_subcommand("sensor", "Allan deviation of an inertial unit of a grade");
  sub->footer(
      "Example: drydock sensor rig_config/sensors/xsens-mti-630.toml --for 5h --allan allan.svg");
  sub->add_option("GRADE", options->grade, "sensor file (TOML) with a table [imu]")->required();
  sub->add_option("--for", options->duration_s, "how long it is recorded: 10min, 5h; default 2h")
      ->transform(running_time);
  sub->add_option("--rate", options->rate_hz, "samples a second; default the grade's, else 100")
      ->check(positive_number);
  sub->add_option("--seed", options->seed, "of all random errors")
      ->capture_default_str()
      ->check(seed_number);
  sub->add_flag("--json", options->json, "JSON instead of a table");
  sub->add_option("--allan", options->allan, "write a plot to this SVG file");
  sub->callback([options, &command] {
    options->grade = rig_config::find_shipped(options->grade, rig_config::sensors);
    command = [options] { return world::show_sensor(*options, stdout, stderr); };
  });
}

}  // namespace drydock::program
