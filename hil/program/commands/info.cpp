#include "hil/info/info.hpp"

#include <memory>
#include <string>
#include <vector>

#include "hil/program/commands.hpp"

namespace drydock::program {

void add_info(CLI::App& app, Command& command) {
  struct Arguments {
    std::vector<std::string> files;
    bool json = false;
  };
  auto a = std::make_shared<Arguments>();
  auto* sub = app.add_subcommand(
      "info", "What is in a recording or a capture: times, links, topics, rates, gaps, faults");
  sub->footer(
      "Example: drydock info dive.mcap\n"
      "         drydock info trace.asc --json\n"
      "         drydock info dive-1.pd0 dive-2.pd0");
  sub->add_option("FILE", a->files, "recording (MCAP), CAN capture, or bytes of one line; several")
      ->required();
  sub->add_flag("--json", a->json,
                "one JSON object instead of text; of several files with `files` and `total`");
  sub->callback(
      [a, &command] { command = [a] { return info::info(a->files, a->json, stdout, stderr); }; });
}

}  // namespace drydock::program
