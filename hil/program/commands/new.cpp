#include <cctype>
#include <memory>

#include "hil/example/start.hpp"
#include "hil/program/commands.hpp"

namespace drydock::program {

void add_new(CLI::App& app, Command& command) {
  auto options = std::make_shared<example::StartOptions>();
  auto* sub = app.add_subcommand("new", "Write a commented start of a file: NAME.toml, here");
  sub->footer(
      "Example: drydock new rig my-bench\n"
      "         drydock new sensor my-imu");
  sub->add_option("KIND", options->kind, "what")
      ->required()
      ->check(CLI::IsMember({"rig", "mission", "waypoints", "sensor", "vehicle"}));
  sub->add_option("NAME", options->name, "its name: letters, digits, - and _, a letter first")
      ->required()
      ->check(CLI::Validator(
          [](const std::string& name) {
            const bool good = name.find_first_not_of(
                                  "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOP"
                                  "QRSTUVWXYZ0123456789-_") == std::string::npos;
            const bool letter_first =
                !name.empty() && std::isalpha(static_cast<unsigned char>(name[0]));
            return good && letter_first
                       ? ""
                       : "'" + name + "' is no name; allowed: my-bench, a letter first";
          },
          "NAME"));
  sub->add_flag("--overwrite", options->overwrite, "replace what is there");
  sub->callback([options, &command] {
    command = [options] { return example::start(*options, stdout, stderr); };
  });
}

}  // namespace drydock::program
