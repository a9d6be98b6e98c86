#include "hil/diff/diff.hpp"

#include <memory>

#include "hil/program/commands.hpp"

namespace drydock::program {

void add_diff(CLI::App& app, Command& command) {
  auto a = std::make_shared<diff::DiffOptions>();
  auto* sub = app.add_subcommand("diff", "Two runs or recordings side by side: what differs");
  sub->footer(
      "Example: drydock diff before.mcap after.mcap --report out\n"
      "         drydock diff monday.json tuesday.json --tolerance 0.01");
  sub->add_option("A", a->a, "MCAP recording, or summary of a run (--json)")->required();
  sub->add_option("B", a->b, "the other one")->required();
  sub->add_option("--tolerance", a->tolerance,
                  "numbers that differ by no more than this part are the same; default 0")
      ->check(CLI::NonNegativeNumber);
  sub->add_option("--report", a->report, "write index.html with both in one plot into this folder");
  sub->add_flag("--json", a->json, "one JSON object instead of a table");
  sub->callback([a, &command] { command = [a] { return diff::diff(*a, stdout, stderr); }; });
}

}  // namespace drydock::program
