#include <fmt/format.h>

#include <cmath>
#include <map>

#include "hil/study/velocity/velocity_study.hpp"

namespace drydock::study {
namespace {

using Json = nlohmann::ordered_json;

std::string metres(double m) { return fmt::format("{:.{}f}", m, m < 100 ? 1 : 0); }

std::string three_mmps(const Eigen::Vector3d& mps) {
  return fmt::format("{:.1f} {:.1f} {:.1f}", 1e3 * mps.x(), 1e3 * mps.y(), 1e3 * mps.z());
}

/// The paper's text about its figures 9, 11 and 13.
std::string_view published(std::string_view which, std::string_view method) {
  static const std::map<std::pair<std::string_view, std::string_view>, std::string_view> said{
      {{"case1", "pure"}, "1.4 km"},          {{"case2", "pure"}, "1.4 km"},
      {{"case1", "earlier"}, "grows slowly"}, {{"case1", "paper"}, "better than earlier"},
      {{"case2", "earlier"}, "diverges"},     {{"case2", "paper"}, "about 400"}};
  const auto found = said.find({which, method});
  return found == said.end() ? "" : found->second;
}

report::Table main_table(const VelocityResults& results) {
  const std::size_t runs = results.cases.front().methods.front().runs();
  const Band band = nees_band(runs);
  report::Table table{
      "Horizontal position error after 5.5 h without a position fix, DVL for 1 h [m]",
      {"case", "method", "RMSE max", "RMSE end", "growth", "worst run", "velocity RMSE [mm/s]",
       "stated", "NEES", "of growth", "paper"},
      {},
      fmt::format(
          "growth: RMSE at the end with each run's initial position error taken out. Velocity: "
          "forward, starboard, down, as the method trusts it. stated: 1 sigma of the position at "
          "the end as the method's own covariance has it; of `pure` that is linear covariance "
          "analysis. NEES: of the horizontal position, over time and runs, over 2: 1 where the "
          "errors are what the covariance says; 95 % of {} runs between {:.2f} and {:.2f}. "
          "`earlier` "
          "and `paper` know of no error of coefficients, log or current that lasts.",
          runs, band.low, band.high)};
  for (const auto& [which, methods] : results.cases) {
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const auto& s = methods[m];
      table.rows.push_back({m == 0 ? fmt::format("{}: {}", which.name, which.what) : "",
                            std::string(velocity_methods[m].name), metres(s.horizontal_rmse_max()),
                            metres(s.horizontal_rmse_end()), metres(s.growth_rmse_end()),
                            metres(s.worst_run()), three_mmps(s.velocity_rmse()),
                            metres(s.stated_sigma_end()), fmt::format("{:.2f}", s.nees_mean()),
                            fmt::format("{:.2f}", s.growth_nees_mean()),
                            std::string(published(which.name, velocity_methods[m].name))});
    }
  }
  return table;
}

report::Table budget_table(const VelocityResults& results) {
  report::Table table{"Error budget of `ours` in case 2: one source at a time",
                      {"source", "RMSE at 5.5 h [m]"},
                      {},
                      fmt::format("{} runs", results.budget_runs)};
  for (const auto& [source, m] : results.budget)
    table.rows.push_back({std::string(source), fmt::format("{:.2f}", m)});
  return table;
}

Json json_of(const VelocityStatistics& s) {
  const auto vector = [](const Eigen::Vector3d& v) { return Json{v.x(), v.y(), v.z()}; };
  const Band band = nees_band(s.runs());
  return {{"horizontal_rmse_max_m", s.horizontal_rmse_max()},
          {"horizontal_rmse_end_m", s.horizontal_rmse_end()},
          {"growth_rmse_end_m", s.growth_rmse_end()},
          {"worst_run_m", s.worst_run()},
          {"velocity_rmse_mps", vector(s.velocity_rmse())},
          {"velocity_mean_error_mps", vector(s.velocity_mean())},
          {"nees_mean", s.nees_mean()},
          {"nees_band_95", {band.low, band.high}},
          {"growth_nees_mean", s.growth_nees_mean()},
          {"stated_sigma_end_m", s.stated_sigma_end()},
          {"runs", s.runs()}};
}

}  // namespace

std::vector<report::Table> velocity_tables(const VelocityResults& results) {
  std::vector<report::Table> tables;
  if (!results.cases.empty()) tables.push_back(main_table(results));
  if (!results.budget.empty()) tables.push_back(budget_table(results));
  return tables;
}

Json velocity_json(const VelocityResults& results) {
  Json json;
  for (std::size_t m = 0; m < velocity_methods.size(); ++m)
    for (const auto& [which, methods] : results.cases)
      json[std::string(velocity_methods[m].name)][std::string(which.name)] = json_of(methods[m]);
  for (const auto& [source, m] : results.budget) json["error_budget_m"][std::string(source)] = m;
  return json;
}

}  // namespace drydock::study
