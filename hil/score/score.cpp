#include "hil/score/score.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "drivers/terminal/exit_codes.hpp"
#include "hil/score/errors.hpp"
#include "hil/score/read_estimates.hpp"
#include "hil/score/read_truth.hpp"
#include "hil/score/score_text.hpp"
#include "hil/score/text_format.hpp"
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
  std::string format = options.format.empty() ? ending_of(path) : options.format;
  if (format == "mcap") return read_mcap(path, options.topic, origin);
  if (!options.topic.empty())
    throw std::invalid_argument("--topic is of an MCAP file; other files have one track");
  if (const auto why = rig_config::file_trouble(path); !why.empty())
    return Problem{fmt::format("{}: {}", path, why)};
  std::ifstream file(path);
  // Names that say no more than that it is text.
  if (options.format.empty() && (format == "csv" || format == "txt")) format = format_of_text(file);
  if (!options.times.empty() && format != "kitti")
    throw std::invalid_argument("--times is of poses of KITTI; other files have times");
  if (format == "csv") return read_csv(file, path, origin);
  if (format == "tum") return read_tum(file, path);
  if (format == "kitti") return read_kitti(file, path, options.times);
  if (format == "gpx") return read_gpx(file, path, origin);
  throw std::invalid_argument(
      fmt::format("{}: give --format, allowed: csv, tum, kitti, gpx, mcap", path));
}

/// Why no estimate has a truth, where the times tell it; else empty.
std::string no_pair_of(const Track& estimates, const Track& truth) {
  if (estimates.empty()) return {};
  const auto [first, last] = std::ranges::minmax(estimates, {}, &State::at);
  if (last.at >= truth.front().at && first.at <= truth.back().at) return {};
  const auto s = [](measurement::Stamp at) { return measurement::seconds(at.time_since_epoch()); };
  return fmt::format(
      "no time in common: the estimates are of {:.3f} to {:.3f} s since 1970, the truth of {:.3f} "
      "to {:.3f} s",
      s(first.at), s(last.at), s(truth.front().at), s(truth.back().at));
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
  if (estimates->track.empty() && estimates->notes.empty())
    estimates->notes.emplace_back("there are no estimates in the file");
  if (pairs.all.empty())
    if (auto why = no_pair_of(estimates->track, truth->track); !why.empty())
      estimates->notes.push_back(std::move(why));
  if (pairs.in_gaps > 0)
    estimates->notes.push_back(fmt::format(
        "{} estimates are in gaps of the truth, of up to {:.2f} s: --longest-gap {:.2f} takes them",
        pairs.in_gaps, pairs.widest_gap_s, std::ceil(100 * pairs.widest_gap_s) / 100));
  if (auto note = align(pairs.all, options.alignment); !note.empty())
    estimates->notes.push_back(std::move(note));
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
