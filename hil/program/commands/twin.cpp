#include "hil/twin/twin.hpp"

#include <memory>

#include "hil/program/capture_arguments.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"
#include "hil/program/options.hpp"
#include "hil/program/part_arguments.hpp"
#include "hil/program/start_argument.hpp"

namespace drydock::program {

namespace {

struct TwinArguments {
  twin::TwinOptions options;
  PartArguments part;
};

}  // namespace

void add_twin(CLI::App& app, Command& command) {
  auto a = std::make_shared<TwinArguments>();
  auto& o = a->options;
  auto& source = o.source;
  auto* sub = app.add_subcommand(
      "twin", "A rig and a mission that sail a recorded dive again, with the same sensors");
  sub->footer(
      "Example: drydock twin dive.mcap -o twin\n"
      "         drydock run twin/rig.toml --speed max\n"
      "         drydock twin dive.pd0 --protocol pd0 --start 41.5,-70.7 -o twin --report out");
  sub->add_option("RECORDING", source.source.capture, "MCAP recording, or capture of one sensor")
      ->required();
  sub->add_option("-o,--out", o.folder, "folder of the twin")->required();
  sub->add_flag("--overwrite", o.overwrite, "write into a folder that is not empty");
  sub->add_option("--every", o.every_s,
                  "time between poses of its track; default 0.1s with the IMU, else 1s")
      ->transform(running_time);
  add_start(*sub, source.origin);
  sub->add_option("--rig", source.rig,
                  "rig file in the place of the recorded one, or with the sensor of a capture")
      ->transform(rig_name);
  a->part.add_only_and_from(*sub);
  a->part.add_to(*sub);
  sub->add_flag("--json", o.json, "one JSON object instead of text");
  sub->add_option("--report", o.report, "write index.html with a map into this folder");
  add_capture(*sub, source.source);
  sub->callback([a, &command] {
    a->options.source.part = a->part.selection();
    command = [a] {
      auto& capture = a->options.source.source;
      must_be_readable(capture.capture);
      capture.description = load_protocol(capture.protocol);
      return twin::twin(a->options, stdout, stderr);
    };
  });
}

}  // namespace drydock::program
