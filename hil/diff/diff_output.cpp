#include "hil/diff/diff_output.hpp"

#include <fmt/format.h>

#include "drivers/text/json_of_any_text.hpp"
#include "hil/diff/diff_figures.hpp"
#include "hil/report/html.hpp"
#include "hil/report/table.hpp"

namespace drydock::diff {
namespace {

std::string cell(const std::optional<Json>& value) {
  if (!value) return "-";
  if (value->is_string()) return value->get<std::string>();
  if (value->is_number_float()) return fmt::format("{:.6g}", value->get<double>());
  return value->dump();
}

report::Table table_of(const Side& a, const Side& b, const Comparison& comparison) {
  report::Table table{
      fmt::format("A: {}, B: {}", a.file, b.file), {"what differs", "A", "B", "B - A"}, {}, {}};
  for (const auto& [what, in_a, in_b, change] : comparison.differences)
    table.rows.push_back(
        {what, cell(in_a), cell(in_b), change ? fmt::format("{:+.6g}", *change) : ""});
  table.note = fmt::format("{} differences; {} values are in both", comparison.differences.size(),
                           comparison.compared);
  return table;
}

Json side_json(const Side& side) {
  return {{"file", side.file},
          {"rig", side.summary.value("rig", "")},
          {"duration_s", side.summary.value("duration_s", 0.0)}};
}

Json value_json(const std::optional<Json>& value) { return value ? *value : Json(nullptr); }

}  // namespace

std::string to_text(const Side& a, const Side& b, const Comparison& comparison) {
  return report::to_text(table_of(a, b, comparison));
}

std::string to_json(const Side& a, const Side& b, const Comparison& comparison) {
  Json root{{"a", side_json(a)},
            {"b", side_json(b)},
            {"compared", comparison.compared},
            {"differences", Json::array()}};
  for (const auto& [what, in_a, in_b, change] : comparison.differences)
    root["differences"].push_back({{"what", what},
                                   {"a", value_json(in_a)},
                                   {"b", value_json(in_b)},
                                   {"change", change ? Json(*change) : Json(nullptr)}});
  return text::json_of_any_text(root) + "\n";
}

std::string to_html(const Side& a, const Side& b, const Comparison& comparison) {
  std::string body = report::to_html(table_of(a, b, comparison));
  if (a.curves && b.curves) {
    body +=
        "<h2>Both in one plot</h2>\n<p class=soft>Times count from the start of each run.</p>\n";
    for (const auto& figure : figures_of(*a.curves, *b.curves))
      body += report::html::figure(figure);
  } else {
    body += "<p class=soft>Plots need two recordings: a summary has no curves.</p>\n";
  }
  return report::html::page("Two runs", body);
}

}  // namespace drydock::diff
