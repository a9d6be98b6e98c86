#include <fmt/format.h>

#include <algorithm>

#include "hil/campaign/report/summary.hpp"
#include "hil/report/html.hpp"

namespace drydock::campaign {
namespace {

/// A page is to stay readable: of more runs than this, every n-th is drawn.
std::size_t step_between_points(std::size_t runs) {
  constexpr std::size_t most_points = 2000;
  return (runs + most_points - 1) / most_points;
}

std::string points_label(std::size_t runs) {
  const std::size_t step = step_between_points(runs);
  return step > 1 ? fmt::format("one of {} runs", step) : "runs";
}

/// The share of the runs up to each value.
report::Figure distribution_plot(const FigureAnalysis& a, std::vector<double> values) {
  std::ranges::sort(values);
  report::Curve curve{.label = points_label(values.size()), .x = {}, .y = {}};
  for (std::size_t i = 0; i < values.size(); i += step_between_points(values.size())) {
    curve.x.push_back(values[i]);
    curve.y.push_back(static_cast<double>(i + 1) / static_cast<double>(values.size()));
  }
  return {.title = a.figure->name + ": distribution",
          .x_label = a.figure->name,
          .y_label = "share of the runs",
          .curves = {std::move(curve)}};
}

/// The figure over a parameter; empty curves if the parameter is no number.
report::Curve scatter(const Column& column, const Plan& plan, std::size_t parameter) {
  const std::size_t runs = column.values.size();
  report::Curve curve{.label = points_label(runs), .x = {}, .y = {}, .points = true};
  for (std::size_t i = 0; i < runs; i += step_between_points(runs)) {
    const Value value = plan.values_of(column.indexes[i])[parameter];
    if (!is_number(value)) continue;
    curve.x.push_back(number_of(value));
    curve.y.push_back(column.values[i]);
  }
  return curve;
}

std::string plots_of(const Results& results, const Plan& plan, const FigureAnalysis& a) {
  const auto& campaign = results.campaign;
  const auto figure = static_cast<std::size_t>(a.figure - campaign.figures.data());
  const Column column = column_of(results, figure);
  std::string body = report::html::figure(distribution_plot(a, column.values));
  for (std::size_t i = 0; i < campaign.parameters.size(); ++i) {
    auto curve = scatter(column, plan, i);
    const auto& name = campaign.parameters[i].name;
    if (curve.x.empty()) continue;
    body += report::html::figure({.title = a.figure->name + " over " + name,
                                  .x_label = name,
                                  .y_label = a.figure->name,
                                  .curves = {std::move(curve)}});
  }
  return body;
}

}  // namespace

std::string to_page(const Summary& summary) {
  const auto& results = *summary.results;
  const Plan plan(results.campaign);
  std::string body =
      fmt::format("<p class=soft>{} of {} runs, {} failed, seed {}</p>\n", results.records.size(),
                  plan.runs(), results.failed(), results.campaign.seed);
  for (const auto& table : tables_of(summary)) body += report::to_html(table);
  if (!summary.figures.empty()) body += "<h2>Figures</h2>\n";
  for (const auto& figure : summary.figures) body += plots_of(results, plan, figure);
  return report::html::page(results.campaign.name, body);
}

}  // namespace drydock::campaign
