#include <gmock/gmock.h>

#include <cmath>

#include "hil/motion/kinematic_trajectory.hpp"
#include "tests/hil/emulate/water_linked_json.hpp"

/// What the emulated DVL reports.
namespace drydock::emulate {
namespace water_linked_json_test {

using testing::ElementsAre;

TEST_F(WaterLinkedJsonDvl, TheKeysStandInTheOrderOfARealLine) {
  run_to(0.05);
  std::vector<std::string> keys;
  const auto& line = room_.said.back().text;
  const auto object = nlohmann::ordered_json::parse(line);
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  EXPECT_THAT(keys, ElementsAre("time", "vx", "vy", "vz", "fom", "covariance", "altitude",
                                "transducers", "velocity_valid", "status", "format", "type",
                                "time_of_validity", "time_of_transmission"));
  EXPECT_EQ(line.find(' '), std::string::npos) << "compact";
  EXPECT_LT(line.size(), 1100U);
}

TEST_F(WaterLinkedJsonDvl, TheReportHoldsTheTruthAndItsAge) {
  const json m = report();
  EXPECT_EQ(m["velocity_valid"], true);
  EXPECT_NEAR(m["vx"], 2.0, 1e-8);
  EXPECT_NEAR(m["vy"], 0.123, 1e-8);
  EXPECT_NEAR(m["vz"], -0.045, 1e-8);
  EXPECT_NEAR(m["altitude"], 30, 0.005);
  EXPECT_EQ(m["time_of_validity"], 1700000000000000);
  EXPECT_EQ(m["time_of_transmission"], 1700000000040000);
  EXPECT_EQ(m["status"], 0);
  EXPECT_EQ(m["format"], "json_v3.3");
}

TEST_F(WaterLinkedJsonDvl, EachBeamIsThePartOfTheVelocityAlongIt) {
  config_.emulate.primary.bias = {0.1, -0.05, 0.02};
  make(trajectory_);
  const json m = report();
  const double tilt = 22.5 * degree;
  EXPECT_NEAR(m["vx"], 2.1, 1e-8);
  for (std::size_t id = 0; id < 4; ++id) {
    const double azimuth = std::array{135, -135, -45, 45}[id] * degree;
    const json& beam = m["transducers"][id];
    EXPECT_EQ(beam["id"], id);
    EXPECT_EQ(beam["beam_valid"], true);
    const double along = std::sin(tilt) * std::cos(azimuth) * m["vx"].get<double>() +
                         std::sin(tilt) * std::sin(azimuth) * m["vy"].get<double>() +
                         std::cos(tilt) * m["vz"].get<double>();
    EXPECT_NEAR(beam["velocity"], along, 1e-7) << id;
    EXPECT_GT(beam["distance"], 30.0) << "along the beam";
  }
}

TEST_F(WaterLinkedJsonDvl, TheMeritIsTheRootOfTheLargestVariance) {
  const json m = report();
  // Four beams of 1.7 mm/s at 22.5 degrees: sigma2 / (2 sin2) across, sigma2 / (4 cos2) along.
  const double sigma2 = 0.0017 * 0.0017, s2 = 0.1464466, c2 = 0.8535534;
  EXPECT_NEAR(m["covariance"][0][0], sigma2 / (2 * s2), 1e-11);
  EXPECT_NEAR(m["covariance"][1][1], sigma2 / (2 * s2), 1e-11);
  EXPECT_NEAR(m["covariance"][2][2], sigma2 / (4 * c2), 1e-11);
  EXPECT_NEAR(m["covariance"][0][2], 0, 1e-11);
  EXPECT_NEAR(m["fom"], std::sqrt(sigma2 / (2 * s2)), 1e-8);
}

TEST_F(WaterLinkedJsonDvl, BeyondItsRangeItHasTheInvalidForms) {
  motion::Truth truth = under_way();
  truth.bed_depth_m = 400;
  const Frozen deep(truth);
  make(deep);
  const json m = report();
  EXPECT_EQ(m["velocity_valid"], false);
  for (const char* key : {"vx", "vy", "vz"}) EXPECT_EQ(m[key], 0) << key;
  EXPECT_EQ(m["altitude"], -1);
  EXPECT_EQ(m["fom"], 2.707);
  EXPECT_EQ(m["transducers"][3]["distance"], -1);
  EXPECT_EQ(m["transducers"][3]["velocity"], 0);
  EXPECT_EQ(m["transducers"][3]["nsd"], -95);
  EXPECT_EQ(m["transducers"][3]["beam_valid"], false);
}

TEST_F(WaterLinkedJsonDvl, TimeIsTheIntervalSinceTheLastReport) {
  const auto reports = sent_until(1, "velocity");
  ASSERT_EQ(reports.size(), 5U);
  for (const json& m : reports) EXPECT_EQ(m["time"], 200);
}

/// Straight ahead at 2 m/s, level.
rig_config::MissionConfig straight() {
  rig_config::MissionConfig mission;
  mission.latitude_rad = 47 * degree;
  mission.speed_mps = 2;
  mission.depth_m = 10;
  mission.ocean.bed.depth_m = 40;
  mission.legs = {{.kind = rig_config::LegKind::straight, .duration_s = 100, .speed_mps = 2}};
  return mission;
}

TEST_F(WaterLinkedJsonDvl, DeadReckoningCountsFromTheLastResetInTheAxesOfThatMoment) {
  const motion::KinematicTrajectory ahead(straight(), start);
  config_.mounting_rad = {0, 5 * degree, 0};  // its bow is 5 degrees up
  make(ahead);
  const auto first = sent_until(50, "position_local");
  EXPECT_EQ(first.size(), 251U) << "5 Hz";
  EXPECT_NEAR(first.back()["x"], 100 * std::cos(5 * degree), 0.01) << "99.6 of 100 m";
  EXPECT_NEAR(first.back()["y"], 0, 0.01);
  EXPECT_NEAR(first.back()["z"], 100 * std::sin(5 * degree), 0.01) << "9 m";
  for (const char* angle : {"roll", "pitch", "yaw"}) EXPECT_NEAR(first.back()[angle], 0, 0.01);
  EXPECT_GT(first.back()["std"], first.at(10)["std"]);
  EXPECT_EQ(first.back()["ts"], 1700000050.0);
  EXPECT_EQ(first.back()["status"], 0);

  EXPECT_EQ(answer_to(R"({"command":"reset_dead_reckoning"})")["success"], true);
  const auto then = sent_until(60, "position_local");
  EXPECT_NEAR(then.at(0)["x"], 0.3 * std::cos(5 * degree), 0.001) << "from 0.05 s to 0.2 s";
  EXPECT_NEAR(then.back()["x"], 2 * 9.95 * std::cos(5 * degree), 0.01);
}

}  // namespace water_linked_json_test
}  // namespace drydock::emulate
