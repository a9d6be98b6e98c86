#include <memory>

#include "drivers/recordings/tasks/recordings.hpp"
#include "hil/program/commands.hpp"
#include "hil/replay/recording_progress.hpp"

namespace drydock::program {

void add_recover(CLI::App& app, Command& command) {
  auto options = std::make_shared<recordings::RecoverOptions>();
  auto* sub = app.add_subcommand("recover", "Make a cut or damaged recording whole again");
  sub->footer("Example: drydock recover dive.mcap -o dive-whole.mcap");
  sub->add_option("RECORDING", options->recording, "recording (MCAP), of whatever program")
      ->required();
  sub->add_option("-o,--output", options->output, "default NAME-recovered.mcap, here");
  sub->add_flag("--overwrite", options->overwrite, "replace what is there");
  sub->callback([options, &command] {
    command = [options] {
      replay::RecordingProgress progress("recover", stderr);
      return recordings::recover(*options, std::ref(progress), stderr);
    };
  });
}

}  // namespace drydock::program
