#include "estimators/roll/roll_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace drydock::roll::roll_watch_test {
namespace {

constexpr double dt = 0.1;
constexpr double longest_s = 18;  // the longest window
/// Ten satellites at ten epochs a second: the roll to 3.4 degrees from one epoch (roll.md).
constexpr double epoch_sigma = 0.06, information = 1 / (epoch_sigma * epoch_sigma);

TEST(RollWatch, AWrongRollShowsAsTheGeometricSumsOfItsWeightsSay) {
  constexpr double error = 0.03;
  RollWatch watch;
  for (int i = 0; i < 10'000; ++i) watch.add({error * information, information}, dt);
  // sum of w is 1 / (1 - k), sum of w^2 is 1 / (1 - k^2), for the longest window
  const double k = std::exp(-dt / longest_s);
  EXPECT_NEAR(watch.statistic(), error / epoch_sigma * std::sqrt((1 + k) / (1 - k)), 1e-9);
  EXPECT_NEAR(watch.error_rad(), error, 1e-12);
  EXPECT_TRUE(watch.contradicts());
}

TEST(RollWatch, AnErrorOfTwoDegreesIsSeenAfterTheSecondsThatItNeeds) {
  constexpr double error = 2 * std::numbers::pi / 180;
  RollWatch watch;
  int epochs = 0;
  for (; !watch.contradicts() && epochs < 1000; ++epochs)
    watch.add({error * information, information}, dt);
  // After n epochs the longest window has s sqrt((1 - k^n) / (1 + k^n)), s the limit of the test
  // above; it is beyond 4 from the n on that this gives.
  const double k = std::exp(-dt / longest_s),
               s = error / epoch_sigma * std::sqrt((1 + k) / (1 - k));
  const double square = RollWatch::limit * RollWatch::limit / (s * s);
  const double n = std::log((1 - square) / (1 + square)) / std::log(k);
  EXPECT_NEAR(n, 48, 1);
  EXPECT_EQ(epochs, std::ceil(n));
}

TEST(RollWatch, SuspectsAnErrorBeforeItContradictsIt) {
  // A window with z sigmas and the error e suspects e^2 (1 - 2.5^2 / z^2). Many epochs of one error
  // make the longest window the loudest.
  constexpr double error = 0.006;
  RollWatch watch;
  for (int i = 0; i < 10'000; ++i) watch.add({error * information, information}, dt);
  const double k = std::exp(-dt / longest_s);
  const double z = error / epoch_sigma * std::sqrt((1 + k) / (1 - k));
  ASSERT_LT(z, RollWatch::limit / 2);
  EXPECT_EQ(watch.suspected_variance(), 0);

  watch.clear();
  for (int i = 0; i < 10'000; ++i) watch.add({1.7 * error * information, information}, dt);
  ASSERT_FALSE(watch.contradicts());
  ASSERT_GT(1.7 * z, 2.5);
  EXPECT_NEAR(watch.suspected_variance(),
              std::pow(1.7 * error, 2) * (1 - std::pow(2.5 / (1.7 * z), 2)), 1e-12);
}

TEST(RollWatch, OfARightFilterItSeldomSuspects) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> score(0, std::sqrt(information));
  RollWatch watch;
  int suspects = 0;
  constexpr int epochs = 360'000;
  for (int i = 0; i < epochs; ++i) {
    watch.add({score(random), information}, dt);
    suspects += watch.suspected_variance() > 0 ? 1 : 0;
  }
  // Two-sided 2.5 sigmas: .0124 of the time for one window, at most four times that for four.
  EXPECT_GT(suspects, 0.0124 * epochs);
  EXPECT_LT(suspects, 4 * 0.0124 * epochs);
}

TEST(RollWatch, OfARightFilterItSeldomSaysAnything) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> score(0, std::sqrt(information));
  RollWatch watch;
  int contradictions = 0;
  constexpr int epochs = 720'000;  // 20 h
  for (int i = 0; i < epochs; ++i) {
    watch.add({score(random), information}, dt);
    if (!watch.contradicts()) continue;
    ++contradictions;
    watch.clear();  // as its filter does
  }
  // Of 720,000 independent normal values 45 are beyond 4, so of four windows at most 181. Their
  // sums go along with each other and with those of the epoch before: about two an hour are left.
  EXPECT_GT(contradictions, 0);
  EXPECT_LT(contradictions, 181);
}

TEST(RollWatch, NumbersThatAreNoneContradict) {
  RollWatch watch;
  EXPECT_FALSE(watch.contradicts());
  watch.add({std::nan(""), information}, dt);
  EXPECT_TRUE(watch.contradicts());
}

}  // namespace
}  // namespace drydock::roll::roll_watch_test
