#include "estimators/consistency/shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace drydock::consistency {
namespace {

/// The shape of 5 s of residuals, five a second, for a vehicle whose value swings with 3 s.
Shape shape_of(const std::function<double(double t, double rate, double value)>& residual) {
  ShapeTest test;
  for (int i = 1; i <= 25; ++i) {
    const double t = 0.2 * i, value = std::sin(2.1 * t), rate = 2.1 * std::cos(2.1 * t);
    test.take(residual(t, rate, value), t, rate, value);
  }
  return test.best();
}

TEST(ShapeTest, TellsAStepFromARamp) {
  EXPECT_EQ(shape_of([](double, double, double) { return 3.0; }), Shape::step);
  EXPECT_EQ(shape_of([](double t, double, double) { return -0.4 * t; }), Shape::ramp);
  EXPECT_EQ(shape_of([](double t, double, double) { return 0.4 * t * t; }), Shape::parabola);
}

TEST(ShapeTest, KnowsARampThatWasFoundLate) {
  EXPECT_EQ(shape_of([](double t, double, double) { return 0.4 * (t + 4); }), Shape::ramp);
}

TEST(ShapeTest, KnowsADelayByTheDerivativeAndAScaleByTheValue) {
  EXPECT_EQ(shape_of([](double, double rate, double) { return -0.5 * rate; }), Shape::delayed);
  EXPECT_EQ(shape_of([](double, double, double value) { return 0.1 * value; }), Shape::scaled);
}

TEST(ShapeTest, SaysStepWhileThereAreFewResiduals) {
  ShapeTest test;
  for (int i = 1; i < 10; ++i) test.take(i, i, 0, 0);
  EXPECT_EQ(test.best(), Shape::step);
}

TEST(ShapeTest, GivesTheAmountOfLeastSquares) {
  ShapeTest test;
  test.take(1, 1, 0, 0);
  test.take(3, 2, 0, 0);
  EXPECT_DOUBLE_EQ(test.amount(Shape::ramp), 7.0 / 5);
  EXPECT_DOUBLE_EQ(test.amount(Shape::step), 2);
}

}  // namespace
}  // namespace drydock::consistency
