#include "hil/campaign/report/analysis.hpp"

#include <algorithm>
#include <cmath>

#include "hil/campaign/statistics/exact_moments.hpp"

namespace drydock::campaign {
namespace {

std::vector<WorstRun> worst_of(const Column& column, Better better) {
  constexpr std::size_t shown = 5;
  std::vector<WorstRun> runs;
  for (std::size_t i = 0; i < column.values.size(); ++i)
    runs.push_back({column.indexes[i], column.values[i]});
  std::ranges::stable_sort(runs, std::ranges::greater{},
                           [&](const WorstRun& run) { return badness(better, run.value); });
  runs.resize(std::min(runs.size(), shown));
  return runs;
}

void add_moments(const std::vector<double>& values, FigureAnalysis& out) {
  ExactMoments moments;
  for (const double value : values) moments.add(value);
  out.mean = moments.mean();
  out.deviation = moments.count() > 1 ? std::sqrt(moments.variance()) : 0;
}

void add_order_statistics(std::vector<double> values, double confidence, FigureAnalysis& out) {
  std::ranges::sort(values);
  out.lowest = values.front();
  out.highest = values.back();
  for (const double p : {0.05, 0.25, 0.5, 0.75, 0.95, 0.99})
    out.quantiles.push_back(quantile_of(values, p, confidence));
}

/// The place of a list's value in the list. Values that stand there twice are one level.
std::size_t level_of(const ParameterConfig& parameter, const Value& value) {
  return static_cast<std::size_t>(std::ranges::find(parameter.list, value) -
                                  parameter.list.begin());
}

Influence influence_of(const ParameterConfig& parameter, std::size_t place, const Plan& plan,
                       const Column& column) {
  Influence influence{.parameter = parameter.name};
  std::vector<double> numbers;
  std::vector<std::size_t> levels;
  for (const std::size_t index : column.indexes) {
    const Value value = plan.values_of(index)[place];
    if (is_number(value)) numbers.push_back(number_of(value));
    if (parameter.draw == Draw::list) levels.push_back(level_of(parameter, value));
  }
  if (numbers.size() == column.values.size())
    influence.correlation = rank_correlation(numbers, column.values);
  if (!levels.empty()) influence.effect = level_effect(levels, column.values);
  return influence;
}

FigureAnalysis analysed(const Results& results, const Plan& plan, std::size_t figure,
                        const Column& column) {
  const auto& campaign = results.campaign;
  FigureAnalysis out{.figure = &campaign.figures[figure], .count = column.values.size()};
  add_moments(column.values, out);
  add_order_statistics(column.values, campaign.confidence, out);
  out.worst = worst_of(column, out.figure->better);
  for (std::size_t i = 0; i < campaign.parameters.size(); ++i)
    out.influences.push_back(influence_of(campaign.parameters[i], i, plan, column));
  return out;
}

}  // namespace

double badness(Better better, double value) {
  if (better == Better::near_zero) return std::abs(value);
  return better == Better::less ? value : -value;
}

std::vector<FigureAnalysis> analysis_of(const Results& results) {
  const Plan plan(results.campaign);
  std::vector<FigureAnalysis> all;
  for (std::size_t i = 0; i < results.campaign.figures.size(); ++i)
    if (const Column column = column_of(results, i); !column.values.empty())
      all.push_back(analysed(results, plan, i, column));
  return all;
}

}  // namespace drydock::campaign
