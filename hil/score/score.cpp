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

boost::system::result<Track, Problem> read_track(const ScoreOptions& options,
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

}  // namespace

int score(const ScoreOptions& options, std::FILE* out, std::FILE* err) try {
  const auto truth = read_truth(options.truth);
  if (!truth) return refused(truth.error().line, terminal::exit_failed, err);
  const auto estimates = read_track(options, truth->origin);
  if (!estimates) return refused(estimates.error().line, terminal::exit_failed, err);
  auto pairs = pairs_of(*estimates, truth->track, measurement::from_seconds(options.longest_gap_s));
  align(pairs.all, options.alignment);
  const auto errors = errors_of(pairs.all, measurement::from_seconds(options.interval_s));
  fmt::print(
      out, "{}",
      options.json ? score_json(errors, pairs, options) : score_text(errors, pairs, options));
  return terminal::exit_of(errors.pairs > 0);
} catch (const std::invalid_argument& error) {
  return refused(error.what(), terminal::exit_usage, err);
}

}  // namespace drydock::score
