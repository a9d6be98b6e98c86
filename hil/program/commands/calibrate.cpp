#include "hil/calibrate/calibrate.hpp"

#include <memory>

#include "hil/program/capture_arguments.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"
#include "hil/program/options.hpp"
#include "hil/program/part_arguments.hpp"

namespace drydock::program {

namespace {

struct CalibrateArguments {
  calibrate::CalibrateOptions options;
  PartArguments part;
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
  sub->add_option("RECORDING", o.source.source.capture, "MCAP recording, or capture of one sensor")
      ->required();
  auto* write = sub->add_option("--write", o.write, "a rig file with what was told, TOML");
  sub->add_flag("--overwrite", o.overwrite, "replace what is there")->needs(write);
  sub->add_option("--report", o.report,
                  "folder for index.html: bounds, correlations, residuals before and after");
  sub->add_flag("--json", o.json, "one JSON object instead of text");
  sub->add_option("--rig", o.source.rig,
                  "rig file in the place of the recorded one, or with the sensor of a capture")
      ->transform(rig_name);
  a->part.add_only_and_from(*sub);
  a->part.add_to(*sub);
  add_capture(*sub, o.source.source);
  sub->callback([a, &command] {
    a->options.source.part = a->part.selection();
    command = [a] {
      auto& capture = a->options.source.source;
      must_be_readable(capture.capture);
      capture.description = load_protocol(capture.protocol);
      return calibrate::calibrate(a->options, stdout, stderr);
    };
  });
}

}  // namespace drydock::program
