#include <fmt/format.h>

#include <cmath>

#include "hil/campaign/report/repeat.hpp"
#include "hil/campaign/report/summary.hpp"

namespace drydock::campaign {
namespace {

using report::Table;

/// Five digits, but never fewer than stand before the point: a time since 1970 is read by its
/// seconds. All of them are in summary.json and results.sqlite.
std::string digits(double value) {
  constexpr double five_digits = 1e5, too_long = 1e15;
  const double size = std::abs(value);
  return size >= five_digits && size < too_long ? fmt::format("{:.0f}", value)
                                                : fmt::format("{:.5g}", value);
}

std::string bounded(const Quantile& q) {
  const auto bound = [](const std::optional<double>& x) { return x ? digits(*x) : "-"; };
  return fmt::format("{} [{}, {}]", digits(q.value), bound(q.low), bound(q.high));
}

std::string percent(double share) { return fmt::format("{:.4g} %", share * 100); }

Table distribution_table(const Summary& summary) {
  const double confidence = summary.results->campaign.confidence;
  Table table{"Distributions",
              {"figure", "runs", "mean", "deviation", "least", "most", "median", "95 %"},
              {},
              fmt::format("in brackets: {} bounds of the quantile from order statistics; -: too "
                          "few runs for one",
                          percent(confidence))};
  for (const auto& a : summary.figures)
    table.rows.push_back({a.figure->name, std::to_string(a.count), digits(a.mean),
                          digits(a.deviation), digits(a.lowest), digits(a.highest),
                          bounded(a.quantiles[2]), bounded(a.quantiles[4])});
  return table;
}

void add_influence(const std::string& figure, const Influence& i, Table& table) {
  if (!i.correlation && !i.effect) return;
  const auto p = [](double value) { return fmt::format("{:.2g}", value); };
  table.rows.push_back(
      {figure, i.parameter, i.correlation ? fmt::format("{:+.3f}", i.correlation->rho) : "-",
       i.correlation ? p(i.correlation->p_value) : "-", i.effect ? percent(i.effect->share) : "-",
       i.effect ? p(i.effect->p_value) : "-"});
}

Table sensitivity_table(const Summary& summary) {
  Table table{"Sensitivity",
              {"figure", "parameter", "rank correlation", "p", "variance between levels", "p"},
              {},
              "p: how likely this much is if the parameter does not matter"};
  for (const auto& a : summary.figures)
    for (const auto& influence : a.influences) add_influence(a.figure->name, influence, table);
  return table;
}

Table worst_table(const Summary& summary) {
  Table table{"Worst runs", {"figure", "run", "value", "repeat it alone"}, {}, ""};
  for (const auto& a : summary.figures)
    for (const auto& run : a.worst)
      table.rows.push_back({a.figure->name, std::to_string(run.index), digits(run.value),
                            repeat_command(summary.results->campaign, summary.path, run.index)});
  return table;
}

Table shift_table(const Summary& summary) {
  Table table{"Since the earlier campaign",
              {"figure", "verdict", "runs", "median worse by", "bounds"},
              {},
              fmt::format("a verdict is wrong with a probability of at most {}",
                          percent(1 - summary.results->campaign.confidence))};
  for (const auto& s : summary.shifts) {
    const auto bound = [](const std::optional<double>& x) { return x ? digits(*x) : "-"; };
    table.rows.push_back(
        {s.figure, to_text(s.verdict),
         fmt::format("{} and {}{}", s.earlier, s.later, s.paired ? ", paired" : ""),
         digits(s.shift.median), fmt::format("[{}, {}]", bound(s.shift.low), bound(s.shift.high))});
  }
  return table;
}

Table failure_table(const Summary& summary) {
  constexpr std::size_t shown = 10;
  const auto& results = *summary.results;
  Table table{"Failed runs", {"run", "why", "repeat it alone"}, {}, ""};
  for (const auto& record : results.records)
    if (!record.failure.empty() && table.rows.size() < shown)
      table.rows.push_back({std::to_string(record.index), record.failure,
                            repeat_command(results.campaign, summary.path, record.index)});
  table.note = fmt::format("{} of {} shown", table.rows.size(), results.failed());
  return table;
}

Table lacking_table(const Summary& summary) {
  const auto& results = *summary.results;
  Table table{"Figures that runs do not have",
              {"figure", "at", "runs without it", "the first is run"},
              {},
              "see what the path has: run the first of them alone, with --only"};
  for (const auto& l : lacking_figures(results))
    table.rows.push_back(
        {l.figure->name, l.figure->at,
         fmt::format("{} of {}", l.runs, results.records.size() - results.failed()),
         std::to_string(l.first)});
  return table;
}

}  // namespace

std::vector<Table> tables_of(const Summary& summary) {
  std::vector<Table> tables;
  for (const auto make : {distribution_table, sensitivity_table, worst_table, shift_table,
                          lacking_table, failure_table})
    if (auto table = make(summary); !table.rows.empty()) tables.push_back(std::move(table));
  return tables;
}

}  // namespace drydock::campaign
