#include <gtest/gtest.h>

#include "hil/study/perturbation.hpp"
#include "hil/study/velocity/velocity_statistics.hpp"

/// Runs side by side in wide registers are the runs that one after the other gives.
namespace drydock::study {
namespace velocity_registers_test {

/// Through a loss of the DVL after ten minutes and its return ten minutes later.
constexpr double end_s = 1210;

std::vector<Contender> contenders(const std::vector<hydrodynamics::Model>& models) {
  std::vector<Contender> all{{Method::pure, &models.front()}};
  for (const auto& model : models)
    for (const auto method : {Method::earlier, Method::paper, Method::ours})
      all.push_back({method, &model});
  return all;
}

void expect_same_bits(const VelocityTrial& a, const VelocityTrial& b) {
  EXPECT_EQ(a.north_m, b.north_m);
  EXPECT_EQ(a.east_m, b.east_m);
  EXPECT_EQ(a.up_m, b.up_m);
  EXPECT_EQ(a.stated_m2, b.stated_m2);
  EXPECT_EQ(a.nees, b.nees);
  EXPECT_EQ(a.growth_nees, b.growth_nees);
  EXPECT_EQ(a.mps, b.mps);
  EXPECT_EQ(a.velocity_mean, b.velocity_mean);
  EXPECT_EQ(a.velocity_square, b.velocity_square);
}

TEST(VelocityRegisters, EveryKindOfThisProcessorGivesTheBitsOfOneRunAfterTheOther) {
  const auto mission = record_velocity_mission(Hull::symmetric, Eigen::Vector2d::Zero(), end_s);
  std::vector<std::vector<hydrodynamics::Model>> models(most_runs);
  std::vector<std::vector<Contender>> methods;
  for (std::size_t run = 0; run < most_runs; ++run) {
    models[run].emplace_back(perturbed(mission_vehicle(Hull::symmetric), run, 0.1));
    methods.push_back(contenders(models[run]));
  }
  std::vector<std::vector<VelocityTrial>> alone;
  for (std::size_t run = 0; run < most_runs; ++run)
    alone.push_back(velocity_trial(mission, {}, true, 1, run, methods[run]));
  EXPECT_NE(alone[0][3].north_m, alone[1][3].north_m);

  for (const Registers& kind : registers().subspan(1)) {
    SCOPED_TRACE(kind.name);
    const auto together =
        velocity_trials(mission, {}, true, 1, 0, std::span(methods).first(kind.width), kind);
    ASSERT_EQ(together.size(), kind.width);
    for (std::size_t run = 0; run < kind.width; ++run)
      for (std::size_t i = 0; i < alone[run].size(); ++i)
        expect_same_bits(alone[run][i], together[run][i]);
  }
}

TEST(VelocityRegisters, LanesWithoutARunChangeNoOther) {
  const auto mission = record_velocity_mission(Hull::symmetric, Eigen::Vector2d::Zero(), 120);
  const std::vector<hydrodynamics::Model> model{hydrodynamics::Model{mission_vehicle({})}};
  const auto method = contenders(model);
  const Registers& widest = registers().back();
  const auto one = velocity_trials(mission, {}, false, 1, 5, {&method, 1}, widest);
  ASSERT_EQ(one.size(), 1U);
  const auto alone = velocity_trial(mission, {}, false, 1, 5, method);
  for (std::size_t i = 0; i < alone.size(); ++i) expect_same_bits(alone[i], one[0][i]);
}

TEST(VelocityRegisters, AreNoWiderThanTheRunsNeedAndThanIsAskedFor) {
  EXPECT_EQ(registers_for(1).width, 1U);
  EXPECT_EQ(registers_for(most_runs, "off").width, 1U);
  EXPECT_EQ(registers_for(most_runs).width, registers().back().width);
  for (const Registers& kind : registers()) {
    EXPECT_EQ(registers_for(kind.width).name, kind.name);
    EXPECT_EQ(registers_for(most_runs, kind.name).name, kind.name);
  }
}

}  // namespace velocity_registers_test
}  // namespace drydock::study
