#include "hil/info/info.hpp"

#include <memory>

#include "hil/program/commands.hpp"

namespace drydock::program {

void add_info(CLI::App& app, Command& command) {
  struct Arguments {
    std::string file;
    bool json = false;
  };
  auto a = std::make_shared<Arguments>();
  auto* sub = app.add_subcommand(
      "info", "What is in a recording or a capture: times, links, topics, rates, gaps, faults");
  sub->footer(
      "Example: drydock info dive.mcap\n"
      "         drydock info trace.asc --json");
  sub->add_option("FILE", a->file, "recording (MCAP), CAN capture, or bytes of one line")
      ->required();
  sub->add_flag("--json", a->json, "one JSON object instead of text");
  sub->callback(
      [a, &command] { command = [a] { return info::info(a->file, a->json, stdout, stderr); }; });
}

}  // namespace drydock::program
