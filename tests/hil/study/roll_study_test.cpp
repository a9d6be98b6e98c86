#include "hil/study/roll/roll_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "hil/study/roll/roll_bound.hpp"
#include "tests/hil/sky/files.hpp"

namespace drydock::study::roll_study_test {
namespace {

class Nobody final : public Progress {
 public:
  void on_run(std::string_view, std::size_t, std::size_t) override {}
  bool stopped() const override { return false; }
};

std::string broadcast_file() {
  return (drydock::sky::test::gnss_corpus() / "brdc1820.10n").string();
}

TEST(RollStudy, SaysInOneLineWhichFileIsMissing) {
  Nobody nobody;
  Options options;
  options.ephemeris = "no-such-file.10n";
  try {
    run_roll_study(options, nobody);
    FAIL() << "there is no such file";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("no GPS navigation file no-such-file.10n"));
    EXPECT_THAT(error.what(), testing::HasSubstr("--ephemeris"));
  }
}

TEST(RollStudy, ReachesItsGoalsInSevenRuns) {
  if (!std::filesystem::exists(broadcast_file())) GTEST_SKIP() << "no " << broadcast_file();
  Nobody nobody;
  // One run under each sky.
  const Options options{.runs = 7, .jobs = 2, .ephemeris = broadcast_file()};
  const auto result = run_roll_study(options, nobody);
  EXPECT_EQ(result.runs, 7u);
  // With a hundred runs the root mean square is known to 7 %, with seven runs to 27 %.
  const auto& ours = result.json["all_satellites"];
  EXPECT_LT(ours["ideal"]["rms_deg"], 0.60 * 1.3);
  EXPECT_LT(ours["wire"]["rms_deg"], 0.65 * 1.3);
  EXPECT_LT(ours["everything"]["rms_deg"], 0.8 * 1.3);
  EXPECT_LT(ours["everything_2hz"]["rms_deg"], 0.8 * 1.3);
  EXPECT_LT(ours["everything"]["convergence_p95_s"], 3.5);
  for (const char* the_case : {"ideal", "wire", "everything", "everything_2hz"}) {
    const auto& figures = ours[the_case];
    EXPECT_NEAR(figures["rms_deg"].get<double>() / figures["efficient_rms_deg"].get<double>(), 1,
                0.08)
        << the_case;
  }
  EXPECT_LT(result.json["paper"]["ideal"]["rms_deg"], 1.9 * 1.2);
  EXPECT_LT(result.json["paper_with_bias"]["ideal"]["rms_deg"], 1.9 * 1.2);
  EXPECT_GT(result.json["paper_bias_0.5"]["ideal"]["rms_deg"], 3);
  EXPECT_GT(result.json["paper"]["ideal"]["raw_p95_deg"], 14);
  EXPECT_LT(result.json["paper"]["ideal"]["raw_p95_deg"], 25);
}

TEST(RollStudy, IsTheSameToTheLastBitWithAnyNumberOfJobs) {
  if (!std::filesystem::exists(broadcast_file())) GTEST_SKIP() << "no " << broadcast_file();
  Nobody nobody;
  Options options{.runs = 2, .jobs = 2, .ephemeris = broadcast_file()};
  const auto two = run_roll_study(options, nobody).json;
  options.jobs = 1;
  EXPECT_EQ(run_roll_study(options, nobody).json, two);
}

TEST(RoundedInformation, IsAllOfItWhenTheStepsAreSmallAgainstTheNoiseAndNoneBelowTheLimit) {
  // The Fisher information of grouped data is smaller by about step^2 / (12 sigma^2) (Sheppard).
  const double sigma = 0.1, step = 0.6 * std::log(10) / 10;
  EXPECT_NEAR(rounded_information(0.6, sigma) * sigma * sigma,
              1 - step * step / (12 * sigma * sigma), 0.03);
  // Far below the limit nothing is ever received.
  EXPECT_LT(rounded_information(-0.6, sigma) * sigma * sigma, 1e-3);
}

TEST(RollBound, IsNoMoreThanThePriorAndFallsWithTheNumberOfEpochs) {
  RollSky sky{{0.6, 2.2, 0}, {}};
  for (int i = 0; i < 8; ++i) sky.toward_ned.push_back(roll::toward_ned(0.2 + 0.15 * i, i));
  const RollCase the_case{.name = "ideal"};
  const RollFlight flight(the_case, sky, 1, 0);
  const double degree = 3.14159265358979323846 / 180;
  const auto bound = roll_bound(the_case, flight, degree, 1e-4 * degree);
  ASSERT_EQ(bound.size(), 1000u);
  // One epoch, one angle: eight satellites with at best 1 / (8.8 / 66.4)^2 deg^-2 each, from the
  // notes.
  EXPECT_GT(std::sqrt(bound[0]) / degree, 7.5 / std::sqrt(8));
  EXPECT_LT(bound[999], bound[99]);
  // If the bias were known at the start, the bound could only be smaller.
  EXPECT_LT(roll_bound(the_case, flight, 0, 0).back(), bound.back());
}

}  // namespace
}  // namespace drydock::study::roll_study_test
