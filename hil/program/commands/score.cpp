#include "hil/score/score.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string_view>

#include "hil/program/commands.hpp"
#include "hil/program/options.hpp"

namespace drydock::program {

namespace {

std::vector<std::string> alignments() {
  return {score::alignment_names.begin(), score::alignment_names.end()};
}

score::Alignment alignment_named(const std::string& name) {
  return static_cast<score::Alignment>(std::ranges::find(score::alignment_names, name) -
                                       score::alignment_names.begin());
}

/// The times of estimates are whole nanoseconds of some centuries.
const CLI::Validator some_seconds(
    [](std::string& text) {
      double value = 0;
      if (CLI::detail::lexical_cast(text, value) && value >= 1e-9 && value <= 1e9)
        return std::string{};
      return fmt::format("'{}' is not allowed; allowed: 1e-9 to 1e9 seconds", text);
    },
    "SECONDS");

}  // namespace

void add_score(CLI::App& app, Command& command) {
  auto options = std::make_shared<score::ScoreOptions>();
  auto* sub = app.add_subcommand("score", "Anyone's estimates against the truth of a recording");
  sub->footer("Example: drydock score mine.csv --truth run.mcap --align yaw --json");
  sub->add_option("ESTIMATES", options->estimates,
                  "CSV, TUM, KITTI, GPX or MCAP: docs/use/score.md")
      ->required();
  sub->add_option("--truth", options->truth, "recording of an emulated vehicle (MCAP)")->required();
  sub->add_option("--format", options->format,
                  "csv, tum, kitti, gpx, mcap; default by the file's name")
      ->check(CLI::IsMember({"csv", "tum", "kitti", "gpx", "mcap"}));
  sub->add_option("--times", options->times, "file of the times of KITTI's poses, a line each");
  sub->add_option("--topic", options->topic, "of estimates, in an MCAP file with several");
  sub->add_option_function<std::string>(
         "--align",
         [options](const std::string& name) { options->alignment = alignment_named(name); },
         "moves the estimates onto the truth first: none, start, yaw, rigid; default none")
      ->transform(CLI::IsMember(alignments(), CLI::ignore_case));
  sub->add_option("--interval", options->interval_s,
                  "of the relative pose error, seconds; default 1")
      ->check(some_seconds);
  sub->add_option("--longest-gap", options->longest_gap_s,
                  "between two truths, seconds; default 0.2: there is no truth in a longer one")
      ->check(some_seconds);
  sub->add_flag("--json", options->json, "the figures as JSON");
  sub->callback([options, &command] {
    command = [options] { return score::score(*options, stdout, stderr); };
  });
}

}  // namespace drydock::program
