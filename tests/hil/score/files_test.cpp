// Files of estimates as other programs write them, and the command as a whole.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "estimators/frame/attitude.hpp"
#include "hil/bench/run.hpp"
#include "hil/score/numbers.hpp"
#include "hil/score/read_estimates.hpp"
#include "hil/score/read_truth.hpp"
#include "hil/score/score.hpp"
#include "rig_config/load.hpp"

namespace drydock::score {
namespace files_test {

constexpr double degree = std::numbers::pi / 180;

TEST(ScoreFile, ATumLineIsEastNorthUpWithItsScalarLast) {
  std::istringstream in("# timestamp tx ty tz qx qy qz qw\n1795593600.000000123 3 4 5 0 0 0 1\n\n");
  const auto track = read_tum(in, "a.tum");
  ASSERT_TRUE(track) << track.error().line;
  ASSERT_EQ(track->size(), 1U);
  EXPECT_EQ(track->front().at.time_since_epoch().count(), 1795593600000000123);
  EXPECT_EQ(track->front().position_ned, Eigen::Vector3d(4, 3, -5));
  EXPECT_NEAR(frame::euler(*track->front().body_to_ned).yaw, 90 * degree, 1e-12) << "bow east";
}

TEST(ScoreFile, ACsvNamesItsColumnsInAnyOrder) {
  std::istringstream in(
      "east_m, t_s, north_m, down_m, heading_deg, roll_deg, pitch_deg, down_sigma_m, "
      "north_sigma_m, "
      "east_sigma_m\r\n2, 10.5, 1, 3, 90, 10, 0, 3, 1, 2\r\n");
  const auto track = read_csv(in, "a.csv", {});
  ASSERT_TRUE(track) << track.error().line;
  ASSERT_EQ(track->size(), 1U);
  EXPECT_EQ(track->front().at.time_since_epoch().count(), 10'500'000'000);
  EXPECT_EQ(track->front().position_ned, Eigen::Vector3d(1, 2, 3));
  EXPECT_NEAR(frame::euler(*track->front().body_to_ned).roll, 10 * degree, 1e-12);
  EXPECT_EQ((*track->front().covariance_m2)(1, 1), 4);
}

TEST(ScoreFile, DegreesAreMetresFromTheFirstTruth) {
  std::istringstream in("valid_at_ns,latitude_deg,longitude_deg,height_m\n7,60.001,5,-2\n");
  const auto track = read_csv(in, "a.csv", {60 * degree, 5 * degree, 0});
  ASSERT_TRUE(track) << track.error().line;
  EXPECT_EQ(track->front().at.time_since_epoch().count(), 7);
  // A minute of latitude at 60 degrees is 1857 m on WGS-84.
  EXPECT_NEAR(track->front().position_ned.x(), 0.06 * 1857, 0.1);
  EXPECT_NEAR(track->front().position_ned.z(), 2, 1e-2);
}

TEST(ScoreFile, WhatIsWrongIsSaidWithItsLine) {
  const auto tum = [](const char* text) {
    std::istringstream in(text);
    return read_tum(in, "a.tum").error().line;
  };
  EXPECT_EQ(tum("1 2 3\n"), "a.tum:1: not t x y z qx qy qz qw");
  EXPECT_EQ(tum("# c\n1 0 0 0 0 0 0 0\n"), "a.tum:2: not t x y z qx qy qz qw");
  EXPECT_EQ(tum("1 nan 0 0 0 0 0 1\n"), "a.tum:1: not t x y z qx qy qz qw");
  const auto csv = [](const char* text) {
    std::istringstream in(text);
    return read_csv(in, "a.csv", {}).error().line;
  };
  EXPECT_EQ(csv("north_m,east_m,down_m\n1,2,3\n"), "a.csv:1: no column t_s or valid_at_ns");
  EXPECT_THAT(csv("t_s,north_m\n"), testing::HasSubstr("a.csv:1: no columns latitude_deg"));
  EXPECT_EQ(csv("t_s,north_m,east_m,down_m\n1,2,3,4\n2,x,3,4\n"),
            "a.csv:3: a time or a position is no number");
}

TEST(ScoreFile, ATimeKeepsItsNanoseconds) {
  EXPECT_EQ(stamp_of_seconds("1795593600.123456789")->time_since_epoch().count(),
            1795593600123456789);
  EXPECT_EQ(stamp_of_seconds("5")->time_since_epoch().count(), 5'000'000'000);
  EXPECT_EQ(stamp_of_seconds("1.5e3")->time_since_epoch().count(), 1'500'000'000'000);
  for (const auto* bad : {"", "x", "1..2", "1e30", "nan"})
    EXPECT_FALSE(stamp_of_seconds(bad)) << bad;
}

/// A run of the demo rig, recorded.
class Scored : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = testing::TempDir() + "drydock-score-" + std::to_string(::getpid());
    std::filesystem::create_directory(folder);
    bench::RunOptions options;
    options.duration_s = 20;
    options.record.path = folder + "/run.mcap";
    testing::internal::CaptureStdout();
    bench::run_lockstep(
        rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml").value(), options);
    testing::internal::GetCapturedStdout();
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(folder); }

  static nlohmann::json scored(const std::string& file, const std::string& topic = {}) {
    ScoreOptions options;
    options.estimates = folder + "/" + file;
    options.truth = folder + "/run.mcap";
    options.topic = topic;
    options.json = true;
    char* text = nullptr;
    std::size_t size = 0;
    std::FILE* out = ::open_memstream(&text, &size);
    EXPECT_EQ(score(options, out, stderr), 0);
    std::fclose(out);
    const auto json = nlohmann::json::parse(std::string(text, size));
    std::free(text);
    return json;
  }

  static inline std::string folder;
};

TEST_F(Scored, TheTruthItselfAsACsvIsOffByItsOffset) {
  const auto truth = read_truth(folder + "/run.mcap");
  ASSERT_TRUE(truth) << truth.error().line;
  ASSERT_GT(truth->track.size(), 400U) << "25 a second";
  std::ofstream file(folder + "/off.csv");
  file << "valid_at_ns,north_m,east_m,down_m\n" << std::setprecision(17);
  for (const auto& pose : truth->track)
    file << pose.at.time_since_epoch().count() << ',' << pose.position_ned.x() + 3 << ','
         << pose.position_ned.y() - 4 << ',' << pose.position_ned.z() << '\n';
  file.close();
  const auto json = scored("off.csv");
  EXPECT_EQ(json["pairs"], truth->track.size());
  EXPECT_NEAR(json["ate_m"]["rms"], 5, 1e-9);
  EXPECT_NEAR(json["ate_m"]["max"], 5, 1e-9);
  EXPECT_NEAR(json["rpe"]["way_m"]["rms"], 0, 1e-9);
  EXPECT_TRUE(json["nees"].is_null());
  EXPECT_TRUE(json["attitude_deg"].is_null());
}

TEST_F(Scored, AnOdometryOfAnMcapIsCompared) {
  const auto json = scored("run.mcap", "/estimate/truth/odometry");
  EXPECT_GT(json["pairs"], 400);
  EXPECT_NEAR(json["ate_m"]["max"], 0, 1e-6) << "the truth's own odometry";
  EXPECT_NEAR(json["attitude_deg"]["max"], 0, 1e-4);
}

}  // namespace files_test
}  // namespace drydock::score
