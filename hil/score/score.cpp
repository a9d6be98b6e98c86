#include "hil/score/score.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

#include "drivers/terminal/exit_codes.hpp"
#include "hil/score/errors.hpp"
#include "hil/score/read_estimates.hpp"
#include "hil/score/read_truth.hpp"
#include "hil/score/score_text.hpp"
#include "rig_config/file_trouble.hpp"

namespace drydock::score {
namespace {

std::string ending_of(const std::string& path) {
  const auto dot = path.rfind('.');
  return dot == std::string::npos ? "" : path.substr(dot + 1);
}

boost::system::result<Estimates, Problem> read_track(const ScoreOptions& options,
                                                     const frame::Position& origin) {
  const std::string& path = options.estimates;
  const std::string format = options.format.empty() ? ending_of(path) : options.format;
  if (format == "mcap") return read_odometry(path, options.topic);
  if (const auto why = rig_config::file_trouble(path); !why.empty())
    return Problem{fmt::format("{}: {}", path, why)};
  std::ifstream file(path);
  if (format == "csv") return read_csv(file, path, origin);
  if (format == "tum" || format == "txt") return read_tum(file, path);
  throw std::invalid_argument(fmt::format("{}: give --format, allowed: csv, tum, mcap", path));
}

int refused(const std::string& line, int code, std::FILE* err) {
  fmt::print(err, "score: {}\n", line);
  return code;
}

/// A file that is not in the order of time has hardly any estimate left, and its figures say
/// nothing.
std::string disorder_of(const Pairs& pairs, const ScoreOptions& options) {
  const auto all = pairs.all.size() + pairs.without_truth + pairs.out_of_order;
  if (2 * pairs.out_of_order <= all) return {};
  return fmt::format(
      "{}: {} of {} estimates are not later than one before them; bring the file into the order of "
      "time",
      options.estimates, pairs.out_of_order, all);
}

}  // namespace

int score(const ScoreOptions& options, std::FILE* out, std::FILE* err) try {
  const auto truth = read_truth(options.truth);
  if (!truth) return refused(truth.error().line, terminal::exit_failed, err);
  auto estimates = read_track(options, truth->origin);
  if (!estimates) return refused(estimates.error().line, terminal::exit_failed, err);
  if (!truth->damage.empty()) estimates->notes.push_back(truth->damage);
  auto pairs =
      pairs_of(estimates->track, truth->track, measurement::from_seconds(options.longest_gap_s));
  if (const auto disorder = disorder_of(pairs, options); !disorder.empty())
    return refused(disorder, terminal::exit_failed, err);
  if (!align(pairs.all, options.alignment))
    estimates->notes.emplace_back(
        "the turn of the alignment is not determined: fewer than three estimates with a truth, or "
        "no movement; they were only shifted, and the shift takes of the error what it can");
  const auto errors = errors_of(pairs.all, measurement::from_seconds(options.interval_s));
  const auto& notes = estimates->notes;
  fmt::print(out, "{}",
             options.json ? score_json(errors, pairs, notes, options)
                          : score_text(errors, pairs, notes, options));
  return terminal::exit_of(errors.pairs > 0);
} catch (const std::invalid_argument& error) {
  return refused(error.what(), terminal::exit_usage, err);
}

}  // namespace drydock::score
