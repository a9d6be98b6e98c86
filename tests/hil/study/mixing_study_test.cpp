#include "hil/study/mixing/mixing_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

/// The mixing study on a few runs. These are enough to check its claims with a wide margin.
namespace drydock::study::mixing_study_test {
namespace {

class NobodyWatches final : public Progress {
 public:
  void on_run(std::string_view, std::size_t, std::size_t) override {}
  bool stopped() const override { return false; }
};

Result study_of(std::size_t runs, unsigned jobs) {
  NobodyWatches nobody;
  return mixing_study({runs, 1, jobs}, nobody);
}

TEST(MixingStudy, KeepsItsPromisesOnTwentyRuns) {
  const auto json = study_of(20, 2).json;
  EXPECT_EQ(json["table3_cells_matched"], 36);
  for (const char* type : {"type2", "type3"}) {
    EXPECT_LT(json[type]["roll_std_deg"], 0.18) << type;
    EXPECT_LT(json[type]["pitch_std_deg"], 0.18) << type;
    EXPECT_LT(json[type]["pitch_mean_peak_135_165_deg"], 0.35) << type;
    EXPECT_GT(json["type1"]["pitch_mean_peak_deg"],
              2.5 * json[type]["pitch_mean_peak_deg"].get<double>());
  }
  for (const auto& ours : {json["compensated"], json["compensated"]["noisy_log"]}) {
    EXPECT_LT(ours["roll_mean_peak_deg"], 0.14);
    EXPECT_LT(ours["pitch_mean_peak_deg"], 0.14);
    EXPECT_LT(ours["max_std_deg"], 0.29);
    EXPECT_GT(ours["nees_mean"], 0.5);
    EXPECT_LT(ours["nees_mean"], 1.5);
  }
  for (const char* type : {"type1", "type2", "type3", "compensated"})
    EXPECT_TRUE(json[type].contains("integral_gain_k2")) << type;
}

TEST(MixingStudy, DoesNotDependOnTheNumberOfJobs) {
  const auto alone = study_of(3, 1), together = study_of(3, 3);
  EXPECT_EQ(alone.json, together.json);
  EXPECT_EQ(alone.tables[0].rows, together.tables[0].rows);
}

TEST(MixingStudy, PerfectSensorsLeaveTheCompensatedOneWithinTwoHundredths) {
  const MixingExperiment experiment;
  const auto outcome = mixing_run(mixing_variants[3], experiment, experiment.ideal);
  ASSERT_EQ(outcome.roll_deg.size(), mixing_points);
  for (std::size_t i = 0; i < mixing_points; ++i) {
    EXPECT_LT(std::abs(outcome.roll_deg[i]), 0.03);
    EXPECT_LT(std::abs(outcome.pitch_deg[i]), 0.02);
  }
}

TEST(MixingStudy, DrawsEveryFigureOfThePaper) {
  std::vector<std::string> titles;
  const auto result = study_of(2, 1);
  for (const auto& figure : result.figures) titles.push_back(figure.title.substr(0, 9));
  for (const char* title :
       {"Figure 8:", "Figure 9:", "Figure 10", "Figure 11", "Figure 12", "Figure 13"})
    EXPECT_THAT(titles, testing::Contains(title));
}

TEST(MixingStudy, ItsWorkloadsAreTheFourTypesAndTheLookUp) {
  auto workloads = mixing_workloads();
  ASSERT_EQ(workloads.size(), 5U);
  EXPECT_EQ(workloads[0].key, "type1");
  for (auto& workload : workloads) workload.run(100);
}

}  // namespace
}  // namespace drydock::study::mixing_study_test
