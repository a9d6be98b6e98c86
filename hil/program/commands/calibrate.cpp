#include "hil/calibrate/calibrate.hpp"

#include <memory>

#include "hil/program/commands.hpp"
#include "hil/program/dive_arguments.hpp"

namespace drydock::program {

namespace {

struct CalibrateArguments {
  calibrate::CalibrateOptions options;
  DiveArguments dive;
};

}  // namespace

void add_calibrate(CLI::App& app, Command& command) {
  auto a = std::make_shared<CalibrateArguments>();
  auto& o = a->options;
  auto* sub = app.add_subcommand(
      "calibrate",
      "Mounting, scale, latency, lever arms and deviation from a dive, with bounds and what it "
      "cannot tell");
  sub->footer(
      "Example: drydock calibrate dive.mcap\n"
      "         drydock calibrate dive.mcap --json\n"
      "         drydock calibrate dive.mcap --write calibrated.toml");
  a->dive.add_files(*sub);
  auto* write = sub->add_option("--write", o.write, "a rig file with what was told, TOML");
  sub->add_flag("--overwrite", o.overwrite, "replace what is there")->needs(write);
  sub->add_option("--report", o.report,
                  "folder for index.html: bounds, correlations, residuals before and after");
  sub->add_flag("--json", o.json, "one JSON object instead of text");
  a->dive.add_rig_and_part(*sub, o.source.rig);
  add_capture(*sub, o.source.source);
  sub->callback([a, &command] {
    a->dive.read(a->options.source);
    command = [a] {
      a->dive.open(a->options.source);
      return calibrate::calibrate(a->options, stdout, stderr);
    };
  });
}

}  // namespace drydock::program
