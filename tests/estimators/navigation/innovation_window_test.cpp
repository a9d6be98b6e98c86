#include "estimators/navigation/innovation_window.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "estimators/navigation/constraint_mean.hpp"

namespace drydock::navigation {
namespace {

TEST(ChiSquare, HasTheTailsOfTheTables) {
  // Upper tails of Abramowitz and Stegun, table 26.8.
  EXPECT_NEAR(chi_square_limit(0.05, 1), 5.99146, 1e-5);
  EXPECT_NEAR(chi_square_limit(0.001, 5), 29.588, 1e-3);
  EXPECT_NEAR(chi_square_limit(0.01, 10), 37.5662, 1e-4);
  EXPECT_NEAR(chi_square_tail(9.34182, 5), 0.5, 1e-5);
}

TEST(InnovationWindow, StandardNormalInnovationsGiveTheSumsOfTheory) {
  // Chi-square with 10 degrees of freedom is above 29.588 in one of 1000 cases; a standard normal
  // value is beyond 3 in 0.27 %. Windows that share no innovation are independent.
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  InnovationWindow window;
  int squares = 0, means = 0;
  constexpr int windows = 100'000;
  for (int k = 0; k < windows; ++k) {
    for (int i = 0; i < InnovationWindow::size; ++i) window.add(normal(random));
    squares += window.squares() > 29.588;
    means += std::abs(window.mean()) > 3;
    ASSERT_FALSE(window.contradicts()) << k;
  }
  EXPECT_NEAR(squares, 0.001 * windows, 5 * std::sqrt(0.001 * windows));
  EXPECT_NEAR(means, 0.0027 * windows, 5 * std::sqrt(0.0027 * windows));
}

TEST(InnovationWindow, ABiasOfTwoSigmasContradictsAfterSevenValues) {
  // The mean of n values of 2 sigmas is 2 sqrt(n) sigmas: beyond 5.33 for n of 8.
  InnovationWindow window;
  int values = 0;
  while (!window.contradicts() && values < 100) {
    window.add(2);
    ++values;
  }
  EXPECT_EQ(values, 8);
}

TEST(InnovationWindow, NoiseOfThreeTimesItsSizeContradictsByItsSquares) {
  // The limit of 1e-7 is 52.3 at ten degrees of freedom: beyond five squares of 9, not six.
  EXPECT_NEAR(chi_square_limit(1e-7, 5), 52.31, 0.01);
  InnovationWindow window;
  for (int i = 0; i < 5; ++i) window.add(i % 2 == 0 ? 3 : -3);
  EXPECT_FALSE(window.contradicts());
  window.add(-3);
  EXPECT_TRUE(window.contradicts());
  EXPECT_NEAR(window.mean(), 0, 1e-12);
}

TEST(InnovationWindow, SingleOutliersAreNotInTheSumsButTooManyContradict) {
  InnovationWindow window;
  for (int i = 0; i < 100; ++i) window.add(i % 10 == 0 ? 1000 : 0);
  EXPECT_FALSE(window.contradicts());
  EXPECT_EQ(window.outliers(), 1);
  // More than 4 of the last 10: the one of the loop has left them by now.
  for (int i = 0; i < 4; ++i) window.add(1000);
  EXPECT_FALSE(window.contradicts());
  window.add(1000);
  EXPECT_TRUE(window.contradicts());
  for (int i = 0; i < 6; ++i) window.add(0);
  EXPECT_FALSE(window.contradicts());
}

TEST(InnovationWindow, AValueThatIsNoNumberIsAnOutlier) {
  InnovationWindow window;
  window.add(std::nan(""));
  EXPECT_EQ(window.outliers(), 1);
  EXPECT_EQ(window.squares(), 0);
}

TEST(ConstraintMean, OfWhiteNoiseIsStandardNormal) {
  // Means that lie ten spans apart are independent.
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  ConstraintMean mean(0.5);
  double squares = 0;
  constexpr int times = 2000;
  for (int k = 0; k < times; ++k) {
    for (int i = 0; i < 500; ++i) mean.add(normal(random), 0.01);
    squares += mean.statistic() * mean.statistic();
  }
  EXPECT_NEAR(squares / times, 1, 5 * std::sqrt(2. / times));
}

TEST(ConstraintMean, OfAConstantGrowsWithTheRootOfItsSpan) {
  // The variance of such a mean is dt / (2 span), so the statistic tends to z sqrt(2 span / dt).
  ConstraintMean mean(2);
  for (int i = 0; i < 10'000; ++i) mean.add(0.3, 0.01);
  EXPECT_NEAR(mean.statistic(), 0.3 * std::sqrt(2 * 2 / 0.01), 0.02);
}

}  // namespace
}  // namespace drydock::navigation
