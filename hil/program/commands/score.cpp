#include "hil/score/score.hpp"

#include <map>
#include <memory>

#include "hil/program/commands.hpp"
#include "hil/program/options.hpp"

namespace drydock::program {

namespace {

std::map<std::string, score::Alignment> alignments() {
  std::map<std::string, score::Alignment> all;
  for (std::size_t i = 0; i < score::alignment_names.size(); ++i)
    all[score::alignment_names.at(i)] = static_cast<score::Alignment>(i);
  return all;
}

}  // namespace

void add_score(CLI::App& app, Command& command) {
  auto options = std::make_shared<score::ScoreOptions>();
  auto* sub = app.add_subcommand("score", "Anyone's estimates against the truth of a recording");
  sub->footer("Example: drydock score mine.csv --truth run.mcap --align yaw --json");
  sub->add_option("ESTIMATES", options->estimates, "CSV, TUM or MCAP: docs/use/score.md")
      ->required();
  sub->add_option("--truth", options->truth, "recording of an emulated vehicle (MCAP)")->required();
  sub->add_option("--format", options->format, "csv, tum, mcap; default by the file's name")
      ->check(CLI::IsMember({"csv", "tum", "mcap"}));
  sub->add_option("--topic", options->topic, "of nav_msgs/Odometry, in an MCAP file with several");
  sub->add_option("--align", options->alignment,
                  "moves the estimates onto the truth first: none, start, yaw, rigid; default none")
      ->transform(CLI::CheckedTransformer(alignments(), CLI::ignore_case));
  sub->add_option("--interval", options->interval_s,
                  "of the relative pose error, seconds; default 1")
      ->check(positive_number);
  sub->add_option("--longest-gap", options->longest_gap_s,
                  "between two truths, seconds; default 0.2: there is no truth in a longer one")
      ->check(positive_number);
  sub->add_flag("--json", options->json, "the figures as JSON");
  sub->callback([options, &command] {
    command = [options] { return score::score(*options, stdout, stderr); };
  });
}

}  // namespace drydock::program
