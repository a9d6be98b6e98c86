#include "hil/study/velocity/velocity_trial.hpp"

#include <gtest/gtest.h>

#include "hil/study/velocity/velocity_statistics.hpp"

namespace drydock::study {
namespace {

/// The first minutes of the mission, sailed once for all tests.
const RecordedMission& beginning() {
  static const RecordedMission mission =
      record_velocity_mission(Hull::symmetric, Eigen::Vector2d::Zero(), 240);
  return mission;
}

const hydrodynamics::Model& exact_model() {
  static const hydrodynamics::Model model{mission_vehicle(Hull::symmetric)};
  return model;
}

std::vector<VelocityTrial> trial(const VelocityErrors& errors, std::size_t run) {
  std::vector<Contender> all;
  for (const auto& method : velocity_methods) all.push_back({method.method, &exact_model()});
  return velocity_trial(beginning(), errors, false, 1, run, all);
}

TEST(VelocityTrial, WithoutSensorErrorsEveryMethodStaysOnTheTrack) {
  VelocityErrors none;
  none.position_m = none.height_m = none.velocity_mps = none.scale = none.depth_m = 0;
  none.alignment_rad.setZero();
  none.accel_bias_mps2 = none.gyro_bias_radps = none.angle_noise_rad = none.velocity_noise_mps = 0;
  none.log_mps = none.ground_mps = 0;
  for (const auto& method : trial(none, 0)) {
    EXPECT_LT(std::hypot(method.north_m.back(), method.east_m.back()), 0.05);
    EXPECT_LT(method.velocity_mean.norm(), 1e-3);
  }
}

TEST(VelocityTrial, TheSdinsAloneErrsAsItsLinearCovarianceSays) {
  constexpr std::size_t runs = 60;
  VelocityStatistics pure(beginning().steps() / VelocityTrial::steps_an_instant + 1);
  const Contender alone{Method::pure, &exact_model()};
  for (std::size_t run = 0; run < runs; ++run)
    pure.add(velocity_trial(beginning(), {}, false, 1, run, {&alone, 1}).front());
  // Three standard errors of an RMSE of 60 runs with two axes each.
  EXPECT_NEAR(pure.horizontal_rmse_end() / pure.stated_sigma_end(), 1, 3 / std::sqrt(4.0 * runs));
  EXPECT_GT(pure.growth_rmse_end(), 20);  // 0.1 m/s for four minutes
  EXPECT_NEAR(pure.nees_mean(), 1, 3 / std::sqrt(runs));
  EXPECT_NEAR(pure.growth_nees_mean(), 1, 3 / std::sqrt(runs));
}

TEST(VelocityStatistics, TheBandOfTheNeesIsThatOfChiSquare) {
  // Tables of chi-square at 2.5 % and 97.5 %: 9.591 and 34.170 for 20 degrees of freedom, 162.728
  // and 241.058 for 200.
  EXPECT_NEAR(nees_band(10).low, 9.591 / 20, 1e-3);
  EXPECT_NEAR(nees_band(10).high, 34.170 / 20, 1e-3);
  EXPECT_NEAR(nees_band(100).low, 162.728 / 200, 1e-4);
  EXPECT_NEAR(nees_band(100).high, 241.058 / 200, 1e-4);
}

TEST(VelocityTrial, OneSeedAndRunGiveOneResult) {
  const auto first = trial({}, 3), again = trial({}, 3), other = trial({}, 4);
  for (std::size_t m = 0; m < first.size(); ++m) {
    EXPECT_EQ(first[m].north_m, again[m].north_m);
    EXPECT_NE(first[m].north_m, other[m].north_m);
  }
}

TEST(VelocityTrial, AMethodDoesNotDependOnWhoElseIsTried) {
  const auto all = trial({}, 5);
  const Contender alone{Method::ours, &exact_model()};
  const auto ours = velocity_trial(beginning(), {}, false, 1, 5, {&alone, 1});
  EXPECT_EQ(all[3].north_m, ours[0].north_m);
}

TEST(MeasuredMission, SensorsComeAtTheRatesOfThePaper) {
  MeasuredMission sensors(beginning(), {}, false, 1, 0);
  int logs = 0, grounds = 0;
  MeasuredStep step;
  for (std::size_t k = 0; k < 1000; ++k) {
    sensors.measure(k, step);
    logs += step.log_mps.has_value();
    grounds += step.ground.has_value();
  }
  EXPECT_EQ(logs, 200);
  EXPECT_EQ(grounds, 100);
}

TEST(RecordedMission, SailsAtThreeMetresASecondToTheNorthEast) {
  const auto& mission = beginning();
  ASSERT_EQ(mission.steps(), 2400U);
  EXPECT_NEAR(mission.instants.back().speed_through_water, 3, 0.05);
  const Eigen::Vector3d way =
      frame::ned_offset(mission.instants.front().position, mission.instants.back().position);
  EXPECT_NEAR(way.x(), 720 * std::sqrt(0.5), 5);
  EXPECT_NEAR(way.y(), 720 * std::sqrt(0.5), 5);
}

}  // namespace
}  // namespace drydock::study
