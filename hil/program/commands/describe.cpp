#include <memory>

#include "drivers/probe/describe.hpp"
#include "hil/program/commands.hpp"

namespace drydock::program {

void add_describe(CLI::App& app, Command& command) {
  auto file = std::make_shared<std::string>();
  auto* sub = app.add_subcommand(
      "describe", "Guess a first description of an unknown sensor from a capture of its bytes");
  sub->footer("Example: drydock describe unknown.bin > sensor.toml");
  sub->add_option("CAPTURE", *file, "bytes as the line carried them")->required();
  sub->callback(
      [file, &command] { command = [file] { return probe::describe(*file, stdout, stderr); }; });
}

}  // namespace drydock::program
