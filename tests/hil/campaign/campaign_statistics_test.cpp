// What the report of a campaign is made of, against exact arithmetic and published examples.
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>

#include "hil/campaign/statistics/comparison.hpp"
#include "hil/campaign/statistics/exact_moments.hpp"
#include "hil/campaign/statistics/quantile.hpp"
#include "hil/campaign/statistics/sensitivity.hpp"

namespace campaign_statistics_test {
namespace {

using namespace drydock::campaign;
using testing::DoubleEq;
using testing::DoubleNear;
using testing::Optional;

const std::string fixtures = DRYDOCK_SOURCE_DIR "/fixtures/scale/";

std::vector<double> ill_conditioned() {
  std::ifstream file(fixtures + "ill_conditioned.txt");
  return {std::istream_iterator<double>(file), {}};
}

nlohmann::json exact_values() {
  return nlohmann::json::parse(std::ifstream(fixtures + "ill_conditioned.json"));
}

ExactMoments one_pass(const std::vector<double>& values) {
  ExactMoments moments;
  for (const double x : values) moments.add(x);
  return moments;
}

TEST(CampaignMoments, AreThoseOfExactFractionsWhereDoublesCancel) {
  const auto values = ill_conditioned();
  ASSERT_EQ(values.size(), 1000u);
  const auto moments = one_pass(values);
  EXPECT_DOUBLE_EQ(moments.mean(), exact_values()["mean"]);
  EXPECT_DOUBLE_EQ(moments.variance(), exact_values()["variance"]);
}

TEST(CampaignMoments, KeepASmallDeviationBesideALargeMean) {
  auto values = ill_conditioned();
  std::erase_if(values, [](double x) { return x < 5e8 || x > 2e9; });
  const auto exact = exact_values()["near_1e9"];
  ASSERT_EQ(values.size(), exact["count"]);
  EXPECT_DOUBLE_EQ(one_pass(values).variance(), exact["variance"]);
  // The textbook's formula in doubles has no digit right here; so this test can fail.
  const double n = static_cast<double>(values.size());
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  const double squares = std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
  const double textbook = (squares - sum * sum / n) / (n - 1);
  EXPECT_GT(std::abs(textbook / exact["variance"].get<double>() - 1), 0.5);
}

RC_GTEST_PROP(CampaignMoments, OfAnyShardsInAnyOrderEqualOnePassToTheLastBit, (unsigned seed)) {
  std::mt19937 random(seed);
  auto values = ill_conditioned();
  const auto whole = one_pass(values);
  std::shuffle(values.begin(), values.end(), random);
  std::vector<ExactMoments> shards(1 + random() % 40);
  for (const double x : values) shards[random() % shards.size()].add(x);
  ExactMoments merged;
  for (const auto& shard : shards) merged.merge(shard);
  RC_ASSERT(merged.count() == whole.count());
  RC_ASSERT(merged.mean() == whole.mean());
  RC_ASSERT(merged.variance() == whole.variance());
}

// Conover, Practical Nonparametric Statistics: bounds of the median at 95 %.
TEST(CampaignQuantile, MedianHasTheRanksOfTheBinomialTable) {
  const auto of_10 = quantile_ranks(10, 0.5, 0.95);
  EXPECT_THAT(of_10.low, Optional(2u));
  EXPECT_THAT(of_10.high, Optional(9u));
  const auto of_100 = quantile_ranks(100, 0.5, 0.95);
  EXPECT_THAT(of_100.low, Optional(40u));
  EXPECT_THAT(of_100.high, Optional(61u));
}

// Wilks 1941: 59 values are the fewest whose largest exceeds the 95 % quantile with 95 %; that is
// one-sided, so with 90 % on two sides.
TEST(CampaignQuantile, NeedsFiftyNineValuesForAnUpperBoundOfThe95PercentQuantile) {
  EXPECT_THAT(quantile_ranks(59, 0.95, 0.90).high, Optional(59u));
  EXPECT_EQ(quantile_ranks(58, 0.95, 0.90).high, std::nullopt);
}

TEST(CampaignQuantile, BoundsEncloseTheTrueQuantileAsOftenAsTheySay) {
  std::mt19937 random(1);
  int enclosed = 0;
  constexpr int trials = 2000, n = 80;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<double> values(n);
    std::exponential_distribution<> exponential;
    for (double& x : values) x = exponential(random);
    std::ranges::sort(values);
    const auto q = quantile_of(values, 0.75, 0.9);
    const double truth = -std::log(0.25);  // of the unit exponential
    enclosed += *q.low <= truth && truth <= *q.high;
  }
  EXPECT_GT(enclosed, 0.88 * trials);
  EXPECT_LT(enclosed, 0.95 * trials);  // not by being wide
}

// The example of Wikipedia, Spearman's rank correlation coefficient: IQ and hours of television.
TEST(CampaignSensitivity, RankCorrelationIsThatOfThePublishedExample) {
  const std::vector<double> iq{106, 100, 86, 101, 99, 103, 97, 113, 112, 110};
  const std::vector<double> hours{7, 27, 2, 50, 28, 29, 20, 12, 6, 17};
  const auto found = rank_correlation(iq, hours);
  ASSERT_TRUE(found);
  EXPECT_DOUBLE_EQ(found->rho, -29.0 / 165);
  EXPECT_NEAR(found->p_value, 0.627188, 1e-6);
}

// The example of Wikipedia, F-test: between 84, within 68, F = 9.3, p = 0.0024.
TEST(CampaignSensitivity, VarianceBetweenLevelsIsThatOfThePublishedExample) {
  const std::vector<double> values{6, 8, 4, 5, 3, 4, 8, 12, 9, 11, 6, 8, 13, 9, 11, 8, 7, 12};
  std::vector<std::size_t> level(18);
  for (std::size_t i = 0; i < level.size(); ++i) level[i] = i / 6;
  const auto found = level_effect(level, values);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->share, 84.0 / 152, 1e-12);
  EXPECT_NEAR(found->p_value, 0.0024, 0.00005);
}

// Three values are in order, or in the opposite one, in 2 of 3! orders; four in 2 of 4!. Of 720
// orders of six values 2 3! 3! keep two groups of three apart.
TEST(CampaignSensitivity, OfFewRunsIsTheShareOfTheirOrders) {
  const std::vector<double> three{1, 2, 3}, four{1, 2, 3, 4}, six{1, 2, 3, 11, 12, 13};
  EXPECT_NEAR(rank_correlation(three, three)->p_value, 2.0 / 6, 1e-12);
  EXPECT_NEAR(rank_correlation(four, four)->p_value, 2.0 / 24, 1e-12);
  EXPECT_NEAR(level_effect(std::vector<std::size_t>{0, 0, 0, 1, 1, 1}, six)->p_value, 0.1, 1e-12);
}

// Counted over all 40320 orders with Python's itertools.
TEST(CampaignSensitivity, OfEightRunsIsTheExactOneOfSpearman) {
  const std::vector<double> x{1, 2, 3, 4, 5, 6, 7, 8}, y{4, 1, 2, 5, 3, 6, 8, 7};
  const auto found = rank_correlation(x, y);
  EXPECT_NEAR(found->rho, 1 - 6.0 * 18 / 504, 1e-12);
  EXPECT_NEAR(found->p_value, 1126.0 / 40320, 1e-12);
}

TEST(CampaignSensitivity, OfMoreRunsIsNeverLessThanThatOfTheBestOrder) {
  std::vector<double> ten(10), apart(10);
  std::vector<std::size_t> level(10);
  for (std::size_t i = 0; i < 10; ++i) {
    ten[i] = static_cast<double>(i);
    level[i] = i / 5;
    apart[i] = i < 5 ? 1 : 2;
  }
  EXPECT_NEAR(rank_correlation(ten, ten)->p_value, 2.0 / 3628800, 1e-15);
  EXPECT_NEAR(level_effect(level, apart)->p_value, 2.0 * 120 * 120 / 3628800, 1e-12);
}

TEST(CampaignSensitivity, SaysNothingWhereAFigureDoesNotVary) {
  const std::vector<double> same(6, 1.0), x{1, 2, 3, 4, 5, 6};
  const std::vector<std::size_t> level{0, 0, 0, 1, 1, 1};
  EXPECT_FALSE(rank_correlation(x, same));
  EXPECT_FALSE(level_effect(level, same));
}

// Hollander and Wolfe, Nonparametric Statistical Methods, permeability of membranes: the difference
// is 0.305. Of the exact distribution of the rank sum, the 8th differences from both ends have 97.2
// %, the 10th 94.5 %.
TEST(CampaignComparison, OfUnpairedRunsIsThatOfThePublishedExample) {
  const std::vector<double> at_term{0.80, 0.83, 1.89, 1.04, 1.45, 1.38, 1.91, 1.64, 0.73, 1.46};
  const std::vector<double> early{1.15, 0.88, 0.90, 0.74, 1.21};
  const auto shift = unpaired_shift(early, at_term, 0.95);
  EXPECT_NEAR(shift.median, 0.305, 1e-12);
  EXPECT_THAT(shift.low, Optional(DoubleNear(-0.17, 1e-12)));
  EXPECT_THAT(shift.high, Optional(DoubleNear(0.76, 1e-12)));
}

// Ten differences 1 to 10: the bounds of the median are the 2nd and the 9th.
TEST(CampaignComparison, OfPairedRunsHasTheRanksOfTheSignTest) {
  std::vector<double> earlier(10), later(10);
  for (int i = 0; i < 10; ++i) {
    earlier[static_cast<std::size_t>(i)] = 100 * i;
    later[static_cast<std::size_t>(i)] = 100 * i + 10 - i;
  }
  const auto shift = paired_shift(earlier, later, 0.95);
  EXPECT_EQ(shift.median, 5.5);
  EXPECT_THAT(shift.low, Optional(DoubleEq(2)));
  EXPECT_THAT(shift.high, Optional(DoubleEq(9)));
}

TEST(CampaignComparison, HasNoBoundsOfFiveValues) {
  const std::vector<double> five{1, 2, 3, 4, 5};
  EXPECT_EQ(paired_shift(five, five, 0.95).low, std::nullopt);
}

}  // namespace
}  // namespace campaign_statistics_test
