#include <nlohmann/json.hpp>

#include "drivers/text/json_of_any_text.hpp"
#include "hil/campaign/report/repeat.hpp"
#include "hil/campaign/report/summary.hpp"

namespace drydock::campaign {
namespace {

using SummaryJson = nlohmann::ordered_json;

constexpr int summary_version = 1;

SummaryJson maybe(const std::optional<double>& value) {
  return value ? SummaryJson(*value) : SummaryJson();
}

SummaryJson of_quantile(const Quantile& q) {
  return {{"p", q.p}, {"value", q.value}, {"low", maybe(q.low)}, {"high", maybe(q.high)}};
}

SummaryJson of_influence(const Influence& influence) {
  SummaryJson json{{"parameter", influence.parameter}};
  if (const auto& c = influence.correlation)
    json["rank_correlation"] = {{"rho", c->rho}, {"p_value", c->p_value}};
  if (const auto& e = influence.effect)
    json["level_effect"] = {{"share_of_variance", e->share}, {"p_value", e->p_value}};
  return json;
}

SummaryJson of_figure(const Summary& summary, const FigureAnalysis& a) {
  SummaryJson json{{"name", a.figure->name},   {"runs", a.count},    {"mean", a.mean},
                   {"deviation", a.deviation}, {"lowest", a.lowest}, {"highest", a.highest}};
  json["quantiles"] = SummaryJson::array();
  for (const auto& q : a.quantiles) json["quantiles"].push_back(of_quantile(q));
  json["worst"] = SummaryJson::array();
  for (const auto& run : a.worst)
    json["worst"].push_back(
        {{"index", run.index},
         {"value", run.value},
         {"command", repeat_command(summary.results->campaign, summary.path, run.index)}});
  json["sensitivity"] = SummaryJson::array();
  for (const auto& influence : a.influences) json["sensitivity"].push_back(of_influence(influence));
  return json;
}

SummaryJson of_shift(const FigureShift& s) {
  return {
      {"figure", s.figure},
      {"verdict", to_text(s.verdict)},
      {"paired", s.paired},
      {"earlier_runs", s.earlier},
      {"runs", s.later},
      {"worse_by",
       {{"median", s.shift.median}, {"low", maybe(s.shift.low)}, {"high", maybe(s.shift.high)}}}};
}

}  // namespace

std::string to_json_text(const Summary& summary) {
  const auto& results = *summary.results;
  SummaryJson json{{"drydock_campaign", summary_version},
                   {"name", results.campaign.name},
                   {"seed", results.campaign.seed},
                   {"runs", Plan(results.campaign).runs()},
                   {"done", results.records.size() - results.failed()},
                   {"failed", results.failed()},
                   {"confidence", results.campaign.confidence}};
  json["figures"] = SummaryJson::array();
  for (const auto& figure : summary.figures) json["figures"].push_back(of_figure(summary, figure));
  json["lacking"] = SummaryJson::array();
  for (const auto& l : lacking_figures(results))
    json["lacking"].push_back({{"figure", l.figure->name},
                               {"at", l.figure->at},
                               {"runs", l.runs},
                               {"first_index", l.first}});
  if (!summary.shifts.empty()) json["since_earlier"] = SummaryJson::array();
  for (const auto& shift : summary.shifts) json["since_earlier"].push_back(of_shift(shift));
  return text::json_of_any_text(json) + "\n";
}

}  // namespace drydock::campaign
