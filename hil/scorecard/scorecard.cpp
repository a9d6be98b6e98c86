#include "hil/scorecard/scorecard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "drivers/terminal/exit_codes.hpp"
#include "hil/motion/make_trajectory.hpp"
#include "hil/report/write_file.hpp"
#include "hil/scorecard/copies.hpp"
#include "hil/scorecard/score_bytes.hpp"
#include "hil/scorecard/scorecard_file.hpp"
#include "hil/scorecard/scorecard_report.hpp"
#include "hil/study/run/study_progress.hpp"

namespace drydock::scorecard {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file || text.str().empty())
    throw std::runtime_error(fmt::format("{}: cannot be read", path.string()));
  return text.str();
}

/// The pairs that the options ask for. Two faults of one device are one trouble.
std::vector<Pair> pairs_for(const rig_config::Rig& rig, const Options& options) {
  auto pairs = pairs_of(rig, options.window, options.devices, options.faults);
  for (Pair& pair : pairs) pair.fault = scaled(pair.fault, options.amount);
  if (options.also.empty()) return pairs;
  const auto also = fault_named(rig, options.window, options.also);
  std::erase_if(pairs, [&](const Pair& pair) { return pair.fault.device == also.device; });
  for (Pair& pair : pairs) pair.also = also;
  return pairs;
}

/// A program that answers with estimates cannot be copied with us.
bool may_be_copied(const rig_config::Rig& rig) {
  return std::ranges::none_of(rig.estimators, [](const rig_config::EstimatorConfig& estimator) {
    return std::holds_alternative<rig_config::ExternalConfig>(estimator.kind);
  });
}

/// The rest of a run with these faults, and what it is worth.
Score score_from_fault_on(Recording& run, const rig_config::Rig& rig, const Pair& pair,
                          const Window& window, const Reference& reference) {
  run.set(pair.fault);
  if (pair.also) run.set(*pair.also);
  return score_of(rig, window, pair, reference, run.run_to(window.run_s()));
}

/// Runs each pair alone, and one run without any fault. The pairs share what comes before the
/// faults: it runs once, and each goes on from there in a copy of this process.
Scorecard play(const rig_config::Rig& asked, const std::vector<Pair>& pairs, const Options& options,
               const study::Options& campaign, study::Progress& progress) {
  rig_config::Rig rig = asked;
  rig.faults.clear();
  Recording sound(rig);
  const Reference reference(sound.run_to(options.window.run_s()));
  const auto begun = [&] {
    auto run = std::make_unique<Recording>(rig, sound);
    run->run_before(options.window.warm_up_s);
    run->make_room(reference.run());  // else each copy would copy what came before, page by page
    return run;
  };
  const auto shared = may_be_copied(rig) ? begun() : nullptr;
  Scorecard card{.rig = rig.name,
                 .seed = rig.seed,
                 .window = options.window,
                 .pairs = pairs.size(),
                 .whole = options.devices.empty() && options.faults.empty() &&
                          options.amount == 1 && options.also.empty(),
                 .scores = {}};
  in_copies(
      "scorecard", campaign, progress,
      [&](std::size_t k) {
        const auto own = shared ? nullptr : begun();
        return to_bytes(
            score_from_fault_on(shared ? *shared : *own, rig, pairs[k], options.window, reference));
      },
      [&](std::string&& bytes) { card.scores.push_back(score_from(bytes)); });
  return card;
}

/// A flight that ends before the run does: its window with the same shares.
Window within_flight(const rig_config::Rig& rig, const Window& asked, std::FILE* errors) {
  const auto flight_s = motion::flight_s(rig);
  if (!flight_s || *flight_s >= asked.run_s()) return asked;
  const double share = *flight_s / asked.run_s();
  const auto whole = [&](double s) { return std::floor(s * share); };
  const Window window{whole(asked.warm_up_s), whole(asked.fault_s), whole(asked.after_s)};
  fmt::print(
      errors,
      "scorecard: the flight ends after {:.1f} s, so each run has {:g} s sound, {:g} s of one "
      "fault, {:g} s behind it\n",
      *flight_s, window.warm_up_s, window.fault_s, window.after_s);
  return window;
}

/// True if the card matches the file. Else it prints a line for each difference.
bool check(const Scorecard& card, const std::string& file, std::FILE* out) {
  const auto differences = differences_from(read(file), card);
  for (const auto& line : differences) fmt::print(out, "{}\n", line);
  if (differences.empty())
    fmt::print(out, "{} pairs are as {} has them\n", card.scores.size(), file);
  else
    fmt::print(out, "{} differences from {}; --update-refs writes it anew\n", differences.size(),
               file);
  return differences.empty();
}

}  // namespace

int run_scorecard(const rig_config::Rig& rig, const Options& asked, std::FILE* out,
                  std::FILE* errors) try {
  Options options = asked;
  options.window = within_flight(rig, asked.window, errors);
  std::vector<Pair> pairs;
  try {
    pairs = pairs_for(rig, options);
  } catch (const std::runtime_error& error) {
    fmt::print(errors, "scorecard: {}\n", error.what());
    return terminal::exit_usage;
  }
  if (pairs.empty()) throw std::runtime_error("no device of the rig can have such a fault");

  study::Options campaign{.runs = pairs.size(), .seed = rig.seed, .jobs = options.jobs};
  if (campaign.jobs == 0) campaign.jobs = std::max(1U, std::thread::hardware_concurrency());
  study::StudyProgress progress(errors);
  const Scorecard card = play(rig, pairs, options, campaign, progress);
  progress.finish("scorecard of " + rig.name, card.scores.size(), campaign);
  if (card.scores.empty()) return terminal::exit_failed;

  fmt::print(out, "{}", to_text(card));
  if (!options.json.empty()) report::write_file(options.json, to_json_text(card));
  if (!options.report.empty()) {
    report::write_file(fs::path(options.report) / "index.html", to_html(card));
    report::write_file(fs::path(options.report) / "heat-map.svg", overview_svg(card));
  }
  const bool complete = card.scores.size() == card.pairs;
  if (!options.update_refs.empty() && complete)
    report::write_file(options.update_refs, to_json_text(card));
  if (!options.update_refs.empty() && !complete)
    fmt::print(errors, "{} is left as it is\n", options.update_refs);
  if (!options.check.empty() && !check(card, options.check, out)) return terminal::exit_failed;
  return terminal::exit_of(complete);
} catch (const std::runtime_error& error) {
  fmt::print(errors, "scorecard: {}\n", error.what());
  return terminal::exit_failed;
}

}  // namespace drydock::scorecard
