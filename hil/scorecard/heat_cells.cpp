#include "hil/scorecard/heat_cells.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace drydock::scorecard {
namespace {

constexpr double shortest_s = 0.05, longest_s = 40;

HeatCell shade(std::string text, double level, std::string tip = {}) {
  return {std::move(text), Tone::shade, level, std::move(tip)};
}

HeatCell recovery(const std::optional<double>& recover_s, const std::string& of) {
  if (!recover_s) return {"not", Tone::alarm, 0, of + ": not within the run"};
  return shade(short_number(*recover_s), log_level(*recover_s, shortest_s, longest_s),
               fmt::format("{}: {:.2f} s behind the fault's end", of, *recover_s));
}

}  // namespace

std::string short_number(double x) {
  if (x >= 99'500) return fmt::format("{:.0f}k", x / 1000);
  if (x >= 9.95) return fmt::format("{:.0f}", x);
  return fmt::format("{:.1f}", x);
}

HeatCell detect_cell(const Score& score) {
  const std::string of = score.device + " " + score.fault;
  if (!score.detect_s) return {"not", Tone::unseen, 0, of + ": not detected"};
  return shade(short_number(*score.detect_s), log_level(*score.detect_s, shortest_s, longest_s),
               fmt::format("{}: {} after {:.2f} s", of, score.sign, *score.detect_s));
}

HeatCell found_cell(const Score& score) {
  const FindingScore& finding = score.finding;
  const std::string of = score.device + " " + score.fault;
  if (!finding.found_s) return {"not", Tone::unseen, 0, of + ": not found"};
  const std::string tip = fmt::format("{}: {} after {:.2f} s", of, finding.word, *finding.found_s);
  if (!finding.right_device) return {"other", Tone::unseen, 0, tip + ", of another device"};
  if (!finding.right_word) return {short_number(*finding.found_s) + "?", Tone::unseen, 0, tip};
  return shade(short_number(*finding.found_s), log_level(*finding.found_s, shortest_s, longest_s),
               tip);
}

HeatCell others_cell(const Score& score) {
  const auto& others = score.finding.others;
  if (others.empty()) return shade("0", 0);
  return {fmt::format("{}", others.size()), Tone::unseen, 0,
          fmt::format("{} {}: {}", score.device, score.fault, fmt::join(others, ", "))};
}

HeatCell recover_cell(const Score& score) {
  return recovery(score.recover_s, score.device + " " + score.fault);
}

HeatCell lost_cell(std::int64_t lost) {
  const auto text = lost < 0 ? fmt::format("+{}", -lost) : fmt::format("{}", lost);
  return shade(text, log_level(std::abs(static_cast<double>(lost)), 1, 4000));
}

HeatCell wrong_cell(const Score& score) {
  if (score.wrong == 0) return shade("0", 0);
  return {fmt::format("{}", score.wrong), Tone::alarm, 0,
          score.device + " " + score.fault + ": " + score.example};
}

HeatCell mistimed_cell(const Score& score) {
  if (score.mistimed == 0) return shade("0", 0);
  return {fmt::format("{}", score.mistimed), Tone::unseen, 0, score.example};
}

HeatCell lies_cell(const Score& score) {
  return shade(fmt::format("{}", score.lies), log_level(static_cast<double>(score.lies), 1, 4000));
}

double growth_of(const EstimatorScore& e) {
  double growth = e.usual_deg > 0 ? e.error_deg / e.usual_deg : 0;
  if (e.horizontal_m && e.usual_m && *e.usual_m > 0)
    growth = std::max(growth, *e.horizontal_m / *e.usual_m);
  return growth;
}

HeatCell growth_cell(const EstimatorScore& e) {
  const double growth = growth_of(e);
  std::string tip =
      fmt::format("{}: {:.3g} deg, without a fault {:.3g} deg", e.name, e.error_deg, e.usual_deg);
  if (e.horizontal_m) tip += fmt::format("; {:.3g} m, {:.3g} m", *e.horizontal_m, *e.usual_m);
  return shade(short_number(growth), log_level(growth, 1, 100), tip);
}

HeatCell nees_cell(const EstimatorScore& e) {
  if (!e.nees) return {"none", Tone::alarm, 0, e.name + ": never valid"};
  const double growth = e.usual_nees > 0 ? *e.nees / e.usual_nees : 1;
  return shade(short_number(*e.nees), log_level(growth, 1, 1000),
               fmt::format("{}: without a fault {:.3g}", e.name, e.usual_nees));
}

HeatCell recover_cell(const EstimatorScore& e) { return recovery(e.recover_s, e.name); }

}  // namespace drydock::scorecard
