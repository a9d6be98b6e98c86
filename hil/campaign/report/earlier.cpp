#include "hil/campaign/report/earlier.hpp"

#include <algorithm>

#include "hil/campaign/report/analysis.hpp"

namespace drydock::campaign {
namespace {

/// What makes a run the same run in two campaigns.
bool is_same_run(const Plan& a, const Plan& b, std::size_t index) {
  return a.seed_of(index) == b.seed_of(index) && a.values_of(index) == b.values_of(index);
}

bool have_same_parameters(const CampaignConfig& a, const CampaignConfig& b) {
  return std::ranges::equal(a.parameters, b.parameters, {}, &ParameterConfig::name,
                            &ParameterConfig::name);
}

void make_bad(Better better, std::vector<double>& values) {
  for (double& value : values) value = badness(better, value);
}

/// The values of the runs that both have; empty sides where not every common index is the same run.
struct Pairs {
  std::vector<double> earlier, later;
};

Pairs pairs_of(const Results& earlier, const Column& before, const Results& later,
               const Column& after) {
  Pairs pairs;
  if (!have_same_parameters(earlier.campaign, later.campaign)) return {};
  const Plan old_plan(earlier.campaign), new_plan(later.campaign);
  for (std::size_t i = 0, j = 0; i < before.indexes.size() && j < after.indexes.size();) {
    if (before.indexes[i] < after.indexes[j])
      ++i;
    else if (after.indexes[j] < before.indexes[i])
      ++j;
    else {
      if (!is_same_run(old_plan, new_plan, before.indexes[i])) return {};
      pairs.earlier.push_back(before.values[i++]);
      pairs.later.push_back(after.values[j++]);
    }
  }
  return pairs;
}

Verdict verdict_of(const Shift& shift, double within) {
  if (!shift.low || !shift.high) return Verdict::undecided;
  if (*shift.low >= -within && *shift.high <= within) return Verdict::same;
  if (*shift.high < -within) return Verdict::better;
  return *shift.low > within ? Verdict::worse : Verdict::undecided;
}

FigureShift shift_of(const Results& earlier, Column before, const Results& later, Column after,
                     const FigureConfig& figure) {
  make_bad(figure.better, before.values);
  make_bad(figure.better, after.values);
  const Pairs pairs = pairs_of(earlier, before, later, after);
  const double confidence = later.campaign.confidence;
  FigureShift out{.figure = figure.name,
                  .paired = !pairs.later.empty(),
                  .earlier = before.values.size(),
                  .later = after.values.size(),
                  .shift = {}};
  out.shift = out.paired ? paired_shift(pairs.earlier, pairs.later, confidence)
                         : unpaired_shift(before.values, after.values, confidence);
  out.verdict = verdict_of(out.shift, figure.same_within);
  return out;
}

}  // namespace

std::vector<FigureShift> shifts_since(const Results& earlier, const Results& later) {
  std::vector<FigureShift> shifts;
  const auto& old_figures = earlier.campaign.figures;
  for (std::size_t i = 0; i < later.campaign.figures.size(); ++i) {
    const auto& figure = later.campaign.figures[i];
    const auto found = std::ranges::find(old_figures, figure.name, &FigureConfig::name);
    if (found == old_figures.end()) continue;
    auto before = column_of(earlier, static_cast<std::size_t>(found - old_figures.begin()));
    auto after = column_of(later, i);
    if (before.values.empty() || after.values.empty()) continue;
    shifts.push_back(shift_of(earlier, std::move(before), later, std::move(after), figure));
  }
  return shifts;
}

const char* to_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::better: return "better";
    case Verdict::worse: return "worse";
    case Verdict::same: return "same";
    case Verdict::undecided: break;
  }
  return "undecided";
}

}  // namespace drydock::campaign
