#include <memory>

#include "drivers/recordings/tasks/recordings.hpp"
#include "hil/program/commands.hpp"
#include "hil/replay/recording_progress.hpp"

namespace drydock::program {

void add_bisect(CLI::App& app, Command& command) {
  auto options = std::make_shared<recordings::BisectOptions>();
  auto* sub = app.add_subcommand("bisect", "The smallest part of a recording that still fails");
  sub->footer(
      "Example: drydock bisect dive.mcap --run './my_navigation --input {}' -o smallest.mcap");
  sub->add_option("RECORDING", options->recording, "recording (MCAP)")->required();
  sub->add_option("--run", options->command,
                  "for the shell, {} is the part; an exit code other than 0 is the failure")
      ->required();
  sub->add_option("-o,--output", options->output, "default NAME-smallest.mcap, here");
  sub->add_flag("--overwrite", options->overwrite, "replace what is there");
  sub->callback([options, &command] {
    command = [options] {
      replay::RecordingProgress progress("bisect", stderr);
      return recordings::bisect(*options, std::ref(progress), stderr);
    };
  });
}

}  // namespace drydock::program
