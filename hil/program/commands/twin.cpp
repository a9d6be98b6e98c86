#include "hil/twin/twin.hpp"

#include <memory>

#include "hil/program/commands.hpp"
#include "hil/program/dive_arguments.hpp"
#include "hil/program/start_argument.hpp"

namespace drydock::program {

namespace {

struct TwinArguments {
  twin::TwinOptions options;
  DiveArguments dive;
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
  a->dive.add_files(*sub);
  sub->add_option("-o,--out", o.folder, "folder of the twin")->required();
  sub->add_flag("--overwrite", o.overwrite, "write into a folder that is not empty");
  sub->add_option("--every", o.every_s,
                  "time between poses of its track; default 0.1s with the IMU, else 1s")
      ->transform(running_time);
  add_start(*sub, source.origin);
  a->dive.add_rig_and_part(*sub, source.rig);
  sub->add_flag("--json", o.json, "one JSON object instead of text");
  sub->add_option("--report", o.report, "write index.html with a map into this folder");
  add_capture(*sub, source.source);
  sub->callback([a, &command] {
    a->dive.read(a->options.source);
    command = [a] {
      a->dive.open(a->options.source);
      return twin::twin(a->options, stdout, stderr);
    };
  });
}

}  // namespace drydock::program
