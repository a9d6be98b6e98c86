// The truth of a run stands in its recording whether estimates come or not.
#include "hil/bench/truth_teller.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "hil/motion/make_trajectory.hpp"
#include "rig_config/load.hpp"

namespace drydock::bench {
namespace truth_teller_test {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr measurement::Stamp start = measurement::stamp_from_ns(1'700'000'000'000'000'000);

struct Ear final : host::Follower {
  void on_truth(const host::Estimate& truth) override { at.push_back(truth.attitude.valid_at); }
  std::chrono::nanoseconds widest() const {
    std::chrono::nanoseconds widest{};
    for (std::size_t i = 1; i < at.size(); ++i) widest = std::max(widest, at[i] - at[i - 1]);
    return widest;
  }
  std::vector<measurement::Stamp> at;
};

class Told : public testing::Test {
 protected:
  void estimate(measurement::Stamp at) {
    host::Estimate one;
    one.attitude.valid_at = at;
    teller_.on_estimate(one);
  }

  std::unique_ptr<motion::Trajectory> truth_ = motion::make_trajectory(
      rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml").value().mission, start);
  Ear ear_;
  TruthTeller teller_{*truth_, ear_, start, seconds{1}};
};

TEST_F(Told, FourEstimatesASecondHaveTheTruthBetweenThem) {
  for (int i = 1; i <= 40; ++i) estimate(start + milliseconds{250} * i);
  EXPECT_LE(ear_.widest(), milliseconds{60});
  EXPECT_EQ(ear_.at.back(), start + seconds{10});
  EXPECT_TRUE(std::ranges::is_sorted(ear_.at));
  for (int i = 1; i <= 40; ++i)
    EXPECT_EQ(std::ranges::count(ear_.at, start + milliseconds{250} * i), 1) << i;
}

TEST_F(Told, ASilenceIsFilledAsItLasts) {
  estimate(start + milliseconds{100});
  for (int s = 1; s <= 15; ++s) teller_.tick(start + seconds{s});
  EXPECT_GT(ear_.at.back(), start + milliseconds{13'900});
  EXPECT_LT(ear_.at.back(), start + seconds{14}) << "an estimate may yet come";
  teller_.finish(start + seconds{15});
  EXPECT_GT(ear_.at.back(), start + milliseconds{14'900});
  EXPECT_LE(ear_.widest(), milliseconds{60});
}

TEST_F(Told, WithoutAnyEstimateItIsToldToo) {
  for (int s = 1; s <= 4; ++s) teller_.tick(start + seconds{s});
  teller_.finish(start + seconds{4});
  EXPECT_NEAR(static_cast<double>(ear_.at.size()), 100, 2);
  EXPECT_LE(ear_.widest(), milliseconds{60});
}

TEST_F(Told, AtAHundredEstimatesASecondItIsThatOfEveryFourth) {
  for (int i = 0; i < 400; ++i) estimate(start + milliseconds{10} * i);
  EXPECT_EQ(ear_.at.size(), 100U);
}

TEST_F(Told, OfTwoEstimatorsNoneBringsAnOlderTruth) {
  for (int i = 0; i < 400; ++i) {
    estimate(start + milliseconds{50} * i);
    if (i > 0) estimate(start + milliseconds{50} * i - milliseconds{49});
  }
  EXPECT_TRUE(std::ranges::is_sorted(ear_.at));
  EXPECT_EQ(std::ranges::adjacent_find(ear_.at), ear_.at.end());
  EXPECT_LE(ear_.widest(), milliseconds{60});
}

TEST_F(Told, AfterAClockThatWasSetBackItGoesOn) {
  estimate(start + std::chrono::hours{1});
  for (int i = 0; i < 100; ++i) estimate(start + milliseconds{50} * i);
  EXPECT_EQ(ear_.at.size(), 101U);
}

TEST_F(Told, AStepOfTheClockIsNoSilence) {
  estimate(start);
  estimate(start + std::chrono::hours{1});
  EXPECT_EQ(ear_.at.size(), 2U);
}

}  // namespace truth_teller_test
}  // namespace drydock::bench
