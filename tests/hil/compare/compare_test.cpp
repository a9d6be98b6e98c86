#include "hil/compare/compare.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "drivers/recordings/export/exporter.hpp"
#include "hil/bench/run.hpp"
#include "rig_config/load.hpp"

namespace drydock::compare {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// 60 s of the demo rig in virtual time, recorded, with the summary of that run.
class Comparing : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = fs::temp_directory_path() / ("compare-test-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    bench::RunOptions options;
    options.duration_s = 60;
    options.quiet = true;
    options.record.path = recording();
    run_ = bench::run_lockstep(demo(), options);
  }
  static void TearDownTestSuite() { fs::remove_all(folder_); }

  static rig_config::Rig demo() {
    return rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml").value();
  }
  static std::string recording() { return (folder_ / "run.mcap").string(); }

  static CompareOptions of(const std::string& source, std::vector<std::string> estimators) {
    CompareOptions options;
    options.source.capture = source;
    options.estimators = std::move(estimators);
    options.duration_s = 60;
    return options;
  }
  static Comparison on_rig(std::vector<std::string> estimators) {
    return compare_on_rig(demo(), of("demo.toml", std::move(estimators)));
  }

  static inline fs::path folder_;
  static inline summary::Summary run_;
};

TEST_F(Comparing, AnEstimatorHasTheFiguresOfTheRunThatItSatIn) {
  const auto comparison = on_rig({"mixing", "leveling"});
  ASSERT_EQ(comparison.entries.size(), 2u);
  const auto& mine = comparison.entries[1].summary;
  const auto& alone = run_.estimators.at(0);
  EXPECT_EQ(mine.estimates, alone.estimates);
  EXPECT_DOUBLE_EQ(mine.whole_run->roll_rms_deg, alone.whole_run->roll_rms_deg);
  EXPECT_DOUBLE_EQ(mine.whole_run->pitch_max_deg, alone.whole_run->pitch_max_deg);
  EXPECT_DOUBLE_EQ(*mine.nis, *alone.nis);
  EXPECT_EQ(mine.rejected, alone.rejected);
}

TEST_F(Comparing, ARecordingGivesTheSameEstimatesAsTheRunThatItIsOf) {
  const auto comparison = compare_on_recording(of(recording(), {"leveling", "leveling"}));
  const auto& alone = run_.estimators.at(0);
  for (const auto& entry : comparison.entries) {
    EXPECT_NEAR(static_cast<double>(entry.summary.estimates), static_cast<double>(alone.estimates),
                30);  // the recording ends with the run
    // The recorded truth lies on lines between times 40 ms apart.
    EXPECT_NEAR(entry.summary.whole_run->roll_rms_deg, alone.whole_run->roll_rms_deg, 0.002);
  }
  EXPECT_EQ(comparison.entries[0].summary.estimates, comparison.entries[1].summary.estimates);
  EXPECT_EQ(comparison.entries[0].summary.nis, comparison.entries[1].summary.nis);
}

/// The run's lines and buses in one pcapng file, with their times, and the rig file by hand.
class ComparingOnCaptures : public Comparing {
 protected:
  static CompareOptions through_demo(std::vector<std::string> estimators) {
    const auto capture = (folder_ / "run.pcapng").string();
    EXPECT_TRUE(exporting::export_recording(recording(), {}, exporting::Format::pcapng,
                                            {capture, true}, [](double) { return true; }));
    auto options = of(capture, std::move(estimators));
    options.rig = DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml";
    options.captures = {{capture}};
    return options;
  }
};

TEST_F(ComparingOnCaptures, HaveTheFiguresOfTheRecordingThatTheyWereTakenFrom) {
  const std::vector<std::string> estimators{"leveling", "mixing"};
  const auto captured = compare_through_rig(through_demo(estimators));
  const auto recorded = compare_on_recording(of(recording(), estimators));
  EXPECT_FALSE(captured.truth);
  EXPECT_THAT(captured.notes, testing::Contains(HasSubstr("read by dvl")));
  ASSERT_EQ(captured.entries.size(), 2u);
  EXPECT_GT(captured.entries[0].summary.estimates, 1000u);
  for (std::size_t i = 0; i < captured.entries.size(); ++i) {
    EXPECT_EQ(captured.entries[i].summary.estimates, recorded.entries[i].summary.estimates);
    EXPECT_EQ(captured.entries[i].used, recorded.entries[i].used);
    EXPECT_EQ(captured.entries[i].summary.nis, recorded.entries[i].summary.nis);
  }
}

TEST_F(ComparingOnCaptures, RefuseAnEstimatorWhoseDeviceNobodyCaptured) {
  for (const std::string estimator : {"leveling", "mixing"}) {  // the rig's own, and a new one
    auto options = through_demo({estimator});
    options.captures = {{DRYDOCK_SOURCE_DIR "/fixtures/pd0/golden.pd0", "dvl"}};
    try {
      compare_through_rig(options);
      FAIL() << estimator;
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), HasSubstr(estimator));
      EXPECT_THAT(error.what(), HasSubstr("nothing was captured: emlog, gnss, imu"));
    }
  }
}

// Both sensors of the demo rig have constant biases. The augmented filter estimates them, the
// robust one does not: docs/estimators/leveling.md.
TEST_F(Comparing, TheFilterThatEstimatesBiasesIsTheBetterOneUnderBiases) {
  const auto comparison = on_rig({"leveling:filter=robust", "leveling"});
  EXPECT_LT(comparison.entries[1].summary.whole_run->pitch_rms_deg,
            comparison.entries[0].summary.whole_run->pitch_rms_deg);
}

TEST_F(Comparing, CountsMeasurementsAndProcessorTime) {
  const auto comparison = on_rig({"leveling",
                                  "dead-reckoning:heading=:reckoning.latitude_deg=36:"
                                  "reckoning.longitude_deg=129"});
  const auto& leveling = comparison.entries[0];
  // 60 s with an IMU at 100 Hz, a log at 2 Hz and a DVL at 5 Hz that watches the IMU, and what is
  // in flight at the end.
  EXPECT_NEAR(static_cast<double>(leveling.used), 60 * 107, 60);
  EXPECT_GT(comparison.measurements, leveling.used);
  EXPECT_GT(leveling.cost_us(), 0.1);
  EXPECT_LT(leveling.cost_us(), 1000);
  const auto& reckoning = comparison.entries[1];
  ASSERT_TRUE(reckoning.summary.navigation);
  EXPECT_LT(reckoning.summary.navigation->horizontal_max_m, 20);
  EXPECT_TRUE(std::isfinite(reckoning.summary.navigation->nees_position));
}

TEST_F(Comparing, SaysWhichChoiceIsWrong) {
  const auto refusal = [](const std::string& choice) -> std::string {
    try {
      on_rig({"leveling", choice});
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_THAT(refusal("kalman"),
              HasSubstr("--estimators kalman: kalman: the rig has no estimator"));
  EXPECT_THAT(refusal("leveling:filter=best"),
              HasSubstr("--estimators leveling:filter=best: /estimator/0/filter"));
}

TEST_F(Comparing, PrintsATableJsonAndAPage) {
  auto options = of(recording(), {"leveling", "mixing"});
  options.json = true;
  options.report = (folder_ / "out").string();
  testing::internal::CaptureStdout();
  EXPECT_EQ(compare(nullptr, options, stdout, stderr), 0);
  std::fflush(stdout);
  const auto json = nlohmann::json::parse(testing::internal::GetCapturedStdout());
  ASSERT_EQ(json["estimators"].size(), 2u);
  EXPECT_EQ(json["estimators"][1]["kind"], "mixing");
  EXPECT_TRUE(json["estimators"][1]["nis"].is_null());  // the filter has no innovations
  EXPECT_GT(json["estimators"][0]["attitude"]["roll_rms_deg"], 0);
  EXPECT_TRUE(fs::exists(folder_ / "out" / "index.html"));
  options.json = false;
  options.report.clear();
  testing::internal::CaptureStdout();
  compare(nullptr, options, stdout, stderr);
  std::fflush(stdout);
  EXPECT_THAT(testing::internal::GetCapturedStdout(), HasSubstr("roll RMS [deg]"));
}

measurement::Stamp at(double s) { return measurement::Stamp{} + measurement::from_seconds(s); }

TEST(Gaps, AreThreeTimesTheUsualStepAndLonger) {
  EXPECT_EQ(gaps_of({}).count, 0u);
  EXPECT_EQ(gaps_of({at(1)}).longest_s, 0);
  const auto gaps = gaps_of({at(0), at(1), at(2), at(5), at(6), at(9.5), at(10.5)});
  EXPECT_EQ(gaps.count, 1u);  // 3.5 s; 3 s are three steps
  EXPECT_NEAR(gaps.longest_s, 3.5, 1e-9);
}

}  // namespace
}  // namespace drydock::compare
