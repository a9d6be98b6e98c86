#include <gtest/gtest.h>

#include <set>

#include "hil/study/perturbation.hpp"
#include "hil/study/velocity/velocity_study.hpp"

/// The results that `drydock study velocity` must show, on few runs of the mission's first 20
/// minutes. The DVL is lost after ten minutes.
namespace drydock::study {
namespace velocity_goals_test {

constexpr double lost_s = 600, end_s = 1200;
constexpr std::size_t runs = 3;

/// Case 2: coefficients with errors of 10 %.
CaseResult case2() {
  const auto mission = record_velocity_mission(Hull::symmetric, Eigen::Vector2d::Zero(), end_s);
  CaseResult result{
      velocity_groups().front().cases.back(),
      std::vector(velocity_methods.size(),
                  VelocityStatistics(mission.steps() / VelocityTrial::steps_an_instant + 1))};
  for (std::size_t run = 0; run < runs; ++run) {
    const hydrodynamics::Model model{perturbed(mission_vehicle(Hull::symmetric), run, 0.1)};
    std::vector<Contender> all;
    for (const auto& method : velocity_methods) all.push_back({method.method, &model});
    const auto trials = velocity_trial(mission, {}, true, 1, run, all);
    for (std::size_t m = 0; m < all.size(); ++m) result.methods[m].add(trials[m]);
  }
  return result;
}

TEST(VelocityGoals, WithoutDvlOursHoldsItsPositionWhereTheOthersDoNot) {
  const CaseResult result = case2();
  const auto &pure = result.methods[0], &earlier = result.methods[1], &paper = result.methods[2],
             &ours = result.methods[3];
  EXPECT_LT(ours.growth_rmse_end(), 3);
  EXPECT_LT(ours.horizontal_rmse_max(), 18);
  EXPECT_LT(ours.growth_rmse_end(), paper.growth_rmse_end());
  EXPECT_LT(paper.horizontal_rmse_end(), 0.3 * pure.horizontal_rmse_end());
  // u is u_c times the square root of thrust over drag, each wrong by 10 %: metres for each second.
  EXPECT_GT(earlier.growth_rmse_end(), 0.02 * (end_s - lost_s));
  EXPECT_LT(ours.velocity_rmse().x(), 0.01);
}

TEST(VelocityGoals, JsonHasEveryFigureOfEveryMethod) {
  const auto mission = record_velocity_mission(Hull::symmetric, Eigen::Vector2d::Zero(), 120);
  const hydrodynamics::Model model{mission_vehicle(Hull::symmetric)};
  VelocityResults results;
  CaseResult result{velocity_groups().front().cases.front(), {}};
  for (const auto& [method, name] : velocity_methods) {
    const Contender one{method, &model};
    result.methods.emplace_back(3);
    result.methods.back().add(velocity_trial(mission, {}, false, 1, 0, {&one, 1}).front());
  }
  results.cases.push_back(result);
  results.budget = {{"log noise", 2.5}};
  const auto json = velocity_json(results);
  for (const char* method : {"pure", "earlier", "paper", "ours"}) {
    const auto& figures = json.at(method).at("case1");
    for (const char* key : {"horizontal_rmse_max_m", "horizontal_rmse_end_m", "growth_rmse_end_m",
                            "worst_run_m", "nees_mean", "growth_nees_mean", "stated_sigma_end_m"})
      EXPECT_TRUE(figures.at(key).is_number()) << key;
    EXPECT_EQ(figures.at("velocity_rmse_mps").size(), 3U);
    EXPECT_EQ(figures.at("velocity_mean_error_mps").size(), 3U);
    EXPECT_EQ(figures.at("nees_band_95").size(), 2U);
  }
  EXPECT_EQ(json.at("error_budget_m").at("log noise"), 2.5);
}

TEST(VelocityGoals, EveryCaseHasANameOfItsOwn) {
  const auto names = velocity_case_names();
  EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size());
  for (const char* name : {"case1", "case2", "case2_20", "eml", "asymmetric", "current",
                           "current_across", "dvl_gaps", "all", "error_budget"})
    EXPECT_NE(std::ranges::find(names, name), names.end()) << name;
}

}  // namespace velocity_goals_test
}  // namespace drydock::study
