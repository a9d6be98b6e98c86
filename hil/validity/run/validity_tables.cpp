#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "hil/validity/run/validity.hpp"

namespace drydock::validity {
namespace {

using nlohmann::ordered_json;
using validity::Figures;
using validity::Spread;
using validity::spread_of;

std::string in_us(double value) { return fmt::format("{:.1f}", value); }

std::vector<std::string> floor_row(const char* name, const std::vector<double>& values) {
  const Spread s = spread_of(values);
  return {name,
          "",
          std::to_string(values.size()),
          in_us(s.median_us),
          in_us(s.p50_us),
          in_us(s.p95_us),
          in_us(s.p99_us),
          in_us(s.largest_us),
          "",
          "",
          ""};
}

std::string label(const Figures& of) {
  return of.device == of.what ? of.device : of.device + " " + of.what;
}

/// Shares of |values| in bins of a fifth of a decade from 0.1 us. The first bin includes smaller
/// values.
report::Curve histogram(std::string name, const std::vector<double>& values) {
  constexpr double first_us = 0.1, bins_a_decade = 5;
  constexpr std::size_t bins = 36;
  std::array<double, bins> shares{};
  for (const double value : values) {
    const double place = bins_a_decade * std::log10(std::max(std::abs(value), first_us) / first_us);
    shares[std::min(bins - 1, static_cast<std::size_t>(place))] += 1;
  }
  report::Curve curve{std::move(name), {}, {}, false, true};
  for (std::size_t i = 0; i < bins; ++i) {
    if (shares[i] == 0) continue;
    curve.x.push_back(first_us * std::pow(10, (static_cast<double>(i) + 0.5) / bins_a_decade));
    curve.y.push_back(shares[i] / static_cast<double>(values.size()));
  }
  return curve;
}

ordered_json spread_json(const std::vector<double>& values) {
  const Spread s = spread_of(values);
  return {{"median_us", s.median_us},
          {"p50_us", s.p50_us},
          {"p95_us", s.p95_us},
          {"p99_us", s.p99_us},
          {"largest_us", s.largest_us}};
}

}  // namespace

report::Table table_of(const ValidityRun& run) {
  report::Table table{
      run.baud > 0 ? fmt::format("time of validity at {} baud [us]", run.baud)
                   : "time of validity [us]",
      {"device", "", "n", "median", "p50", "p95", "p99", "largest", "p99 waited", "p99 late",
       "p99 rest"},
      {},
      "valid_at less the time of the sample; all but the median without sign. Waited: for a busy "
      "line or bus; late: the emulator behind its schedule; rest: the driver's part."};
  for (const Figures& of : run.figures) {
    const Spread s = spread_of(of.errors_us);
    table.rows.push_back({of.device, of.what, std::to_string(of.errors_us.size()),
                          in_us(s.median_us), in_us(s.p50_us), in_us(s.p95_us), in_us(s.p99_us),
                          in_us(s.largest_us), in_us(spread_of(of.waited_us).p99_us),
                          in_us(spread_of(of.late_us).p99_us),
                          in_us(spread_of(of.rest_us).p99_us)});
  }
  if (run.floor.timer_late_us.empty()) return table;
  table.rows.push_back(floor_row("this host's timer", run.floor.timer_late_us));
  table.rows.push_back(floor_row("a byte through a pty", run.floor.pty_hop_us));
  return table;
}

report::Table sweep_table(const std::vector<ValidityRun>& runs) {
  report::Table table{"p99 of the error by baud rate [us]", {"device", ""}, {}, {}};
  for (const ValidityRun& run : runs) table.columns.push_back(std::to_string(run.baud));
  const auto add = [&](const std::string& device, const std::string& what, auto p99_in) {
    std::vector<std::string> row{device, what};
    for (const ValidityRun& run : runs) row.push_back(p99_in(run));
    table.rows.push_back(std::move(row));
  };
  for (const Figures& of : runs.front().figures)
    add(of.device, of.what, [&](const ValidityRun& run) -> std::string {
      const auto same = std::ranges::find_if(run.figures, [&](const Figures& other) {
        return other.device == of.device && other.what == of.what;
      });
      if (same == run.figures.end() || same->errors_us.empty()) return "-";
      return in_us(spread_of(same->errors_us).p99_us);
    });
  if (runs.front().floor.timer_late_us.empty()) return table;
  add("this host's timer", "",
      [](const ValidityRun& run) { return in_us(spread_of(run.floor.timer_late_us).p99_us); });
  add("a byte through a pty", "",
      [](const ValidityRun& run) { return in_us(spread_of(run.floor.pty_hop_us).p99_us); });
  return table;
}

std::vector<report::Figure> figures_of(const ValidityRun& run) {
  std::vector<report::Figure> figures;
  constexpr std::size_t in_one = 6;
  for (std::size_t i = 0; i < run.figures.size(); i += in_one) {
    report::Figure figure{run.baud > 0 ? fmt::format("Histogram of errors at {} baud", run.baud)
                                       : "Histogram of errors",
                          "error [us]",
                          "share",
                          {}};
    figure.log_x = figure.log_y = true;
    for (std::size_t k = i; k < std::min(i + in_one, run.figures.size()); ++k)
      figure.curves.push_back(histogram(label(run.figures[k]), run.figures[k].errors_us));
    if (!run.floor.timer_late_us.empty())
      figure.curves.push_back(histogram("this host's timer", run.floor.timer_late_us));
    figures.push_back(std::move(figure));
  }
  return figures;
}

nlohmann::ordered_json json_of(const ValidityRun& run) {
  ordered_json json{{"baud", run.baud > 0 ? ordered_json(run.baud) : nullptr},
                    {"timer", spread_json(run.floor.timer_late_us)},
                    {"pty", spread_json(run.floor.pty_hop_us)},
                    {"devices", ordered_json::array()}};
  for (const Figures& of : run.figures)
    json["devices"].push_back({{"device", of.device},
                               {"what", of.what},
                               {"measurements", of.errors_us.size()},
                               {"unpaired", of.unpaired},
                               {"error", spread_json(of.errors_us)},
                               {"waited", spread_json(of.waited_us)},
                               {"late", spread_json(of.late_us)},
                               {"rest", spread_json(of.rest_us)}});
  return json;
}

}  // namespace drydock::validity
