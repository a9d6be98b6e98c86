// The command as a whole.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <numbers>

#include "hil/bench/run.hpp"
#include "hil/score/read_estimates.hpp"
#include "hil/score/read_truth.hpp"
#include "hil/score/score.hpp"
#include "rig_config/load.hpp"

namespace drydock::score {
namespace files_test {

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

  static nlohmann::json scored(const std::string& file, const std::string& topic = {},
                               int code = 0) {
    ScoreOptions options;
    options.estimates = folder + "/" + file;
    options.truth = folder + "/run.mcap";
    options.topic = topic;
    options.json = true;
    char* text = nullptr;
    std::size_t size = 0;
    std::FILE* out = ::open_memstream(&text, &size);
    EXPECT_EQ(score(options, out, stderr), code);
    std::fclose(out);
    const auto json = nlohmann::json::parse(std::string(text, size));
    std::free(text);
    return json;
  }

  /// What a refused call says.
  static std::string refused(const std::string& file, const std::string& topic = {}) {
    ScoreOptions options;
    options.estimates = folder + "/" + file;
    options.truth = folder + "/run.mcap";
    options.topic = topic;
    testing::internal::CaptureStderr();
    EXPECT_EQ(score(options, stdout, stderr), 1);
    return testing::internal::GetCapturedStderr();
  }

  /// The truth 3 m further north and 4 m further west.
  static void write_off(const std::string& name, bool reversed) {
    auto truth = read_truth(folder + "/run.mcap")->track;
    if (reversed) std::ranges::reverse(truth);
    std::ofstream file(folder + "/" + name);
    file << "valid_at_ns,north_m,east_m,down_m\n" << std::setprecision(17);
    for (const auto& pose : truth)
      file << pose.at.time_since_epoch().count() << ',' << pose.position_ned.x() + 3 << ','
           << pose.position_ned.y() - 4 << ',' << pose.position_ned.z() << '\n';
  }

  static inline std::string folder;
};

TEST_F(Scored, TheTruthItselfAsACsvIsOffByItsOffset) {
  const auto truth = read_truth(folder + "/run.mcap");
  ASSERT_TRUE(truth) << truth.error().line;
  ASSERT_GT(truth->track.size(), 400U) << "25 a second";
  write_off("off.csv", false);
  const auto json = scored("off.csv");
  EXPECT_EQ(json["pairs"], truth->track.size());
  EXPECT_NEAR(json["ate_m"]["rms"], 5, 1e-9);
  EXPECT_NEAR(json["ate_m"]["max"], 5, 1e-9);
  EXPECT_NEAR(json["rpe"]["way_m"]["rms"], 0, 1e-9);
  EXPECT_TRUE(json["nees"].is_null());
  EXPECT_TRUE(json["attitude_deg"].is_null());
  EXPECT_TRUE(json["notes"].empty());
}

/// What a call without a result says in its JSON.
TEST_F(Scored, WithoutATruthForAnyEstimateItSaysWhy) {
  const auto notes_of = [](const std::string& text) {
    std::ofstream(folder + "/none.csv") << "t_s,north_m,east_m,down_m\n" << text;
    return scored("none.csv", {}, 1)["notes"].dump();
  };
  EXPECT_THAT(notes_of(""), testing::HasSubstr("there are no estimates in the file"));
  EXPECT_THAT(notes_of("0.5,1,2,3\n1.5,1,2,3\n"),
              testing::HasSubstr("no time in common: the estimates are of 0.500 to 1.500 s since "
                                 "1970, the truth of 1795"));
}

TEST_F(Scored, DegreesBesideOtherMetresAreSaid) {
  const auto truth = read_truth(folder + "/run.mcap");
  std::ofstream file(folder + "/both.csv");
  file << "valid_at_ns,north_m,east_m,down_m,latitude_deg,longitude_deg,height_m\n"
       << std::setprecision(17);
  const auto& at = truth->origin;
  constexpr double degree = std::numbers::pi / 180;
  for (std::size_t i = 0; i < 2; ++i)  // the second is 60 m off
    file << truth->track[i].at.time_since_epoch().count() << ",0,0,0,"
         << at.latitude_rad / degree + (i == 1 ? 60 / 111'000. : 0) << ','
         << at.longitude_rad / degree << ',' << at.height_m << '\n';
  file.close();
  EXPECT_THAT(scored("both.csv")["notes"].dump(),
              testing::HasSubstr("latitude_deg, longitude_deg, height_m are not the place of "
                                 "north_m, east_m, down_m, which are taken: 1 line, the first is "
                                 "line 3"));
}

TEST_F(Scored, AFileThatIsNotInTheOrderOfTimeHasNoFigures) {
  write_off("reversed.csv", true);
  EXPECT_THAT(refused("reversed.csv"), testing::HasSubstr("bring the file into the order of time"));
}

TEST_F(Scored, AnOdometryOfAnMcapIsCompared) {
  const auto json = scored("run.mcap", "/estimate/truth/odometry");
  EXPECT_GT(json["pairs"], 400);
  EXPECT_NEAR(json["ate_m"]["max"], 0, 1e-6) << "the truth's own odometry";
  EXPECT_NEAR(json["attitude_deg"]["max"], 0, 1e-4);
}

/// A navigation estimate of the program itself has a covariance, and its message has it too.
TEST_F(Scored, AnOdometryBringsItsCovariance) {
  auto rig =
      rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/dead-reckoning.toml").value();
  bench::RunOptions options;
  options.duration_s = 20;
  options.record.path = folder + "/reckoned.mcap";
  testing::internal::CaptureStdout();
  bench::run_lockstep(rig, options);
  testing::internal::GetCapturedStdout();
  const auto read = read_mcap(folder + "/reckoned.mcap", "/estimate/track/odometry", {});
  ASSERT_TRUE(read) << read.error().line;
  ASSERT_GT(read->track.size(), 20U);
  const auto& covariance = read->track.back().position_m2;
  ASSERT_TRUE(covariance);
  EXPECT_GT(covariance->determinant(), 0);
}

TEST_F(Scored, ATopicThatIsNotThereIsRefusedWithThoseThatAre) {
  EXPECT_THAT(refused("run.mcap", "truth"),
              testing::AllOf(testing::HasSubstr("no topic 'truth' of nav_msgs/Odometry, "),
                             testing::HasSubstr("give --topic, one of: "),
                             testing::HasSubstr("/estimate/truth/odometry")));
}

}  // namespace files_test
}  // namespace drydock::score
