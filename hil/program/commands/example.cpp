#include "hil/example/example.hpp"

#include <memory>

#include "hil/program/commands.hpp"

namespace drydock::program {

void add_example(CLI::App& app, Command& command) {
  auto name = std::make_shared<std::string>();
  auto* sub = app.add_subcommand(
      "example",
      "The rigs, missions, sensors, vehicles, descriptions and campaigns that come with it");
  sub->footer(
      "Example: drydock example\n"
      "         drydock example demo > my-rig.toml");
  sub->add_option("EXAMPLE", *name, "prints this one; default a list of all");
  sub->callback([name, &command] {
    command = [name] {
      return name->empty() ? example::list(stdout, stderr) : example::show(*name, stdout, stderr);
    };
  });
}

}  // namespace drydock::program
