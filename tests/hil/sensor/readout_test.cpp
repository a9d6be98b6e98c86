#include "hil/sensor/readout.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hil/sensor/random.hpp"

namespace drydock::sensor {
namespace readout_test {

using rig_config::SensorErrors;

TEST(Readout, SaturatesEachAxisAtItsRange) {
  SensorErrors errors;
  errors.range = {2, 0, 3};
  Readout readout(errors);
  EXPECT_EQ(readout.of({5, 500, -4}), Vector3d(2, 500, -3));
  EXPECT_EQ(readout.of({-1.5, -500, 2.5}), Vector3d(-1.5, -500, 2.5));
}

TEST(Readout, RoundsToTheNearestStep) {
  SensorErrors errors;
  errors.quantisation = {0.25, 0, 10};
  Readout readout(errors);
  EXPECT_EQ(readout.of({0.37, 0.37, -17}), Vector3d(0.25, 0.37, -20));
}

TEST(Readout, QuantisationOfABusySignalIsUniform) {
  SensorErrors errors;
  errors.quantisation = {0.5, 0, 0};
  Readout readout(errors);
  RandomStream input(3, "imu", "input");
  constexpr int n = 100'000;
  double mean = 0, square = 0;
  for (int i = 0; i < n; ++i) {
    const double ideal = 40 * input.uniform();
    const double error = readout.of({ideal, 0, 0}).x() - ideal;
    EXPECT_LE(std::abs(error), 0.25);
    mean += error / n;
    square += error * error / n;
  }
  // Uniform over q: variance q^2 / 12, fourth moment q^4 / 80.
  const double q = 0.5, variance = q * q / 12;
  EXPECT_NEAR(mean, 0, 4 * std::sqrt(variance / n));
  EXPECT_NEAR(square, variance, 4 * std::sqrt((std::pow(q, 4) / 80 - variance * variance) / n));
}

TEST(Readout, CarryingTheRestNoSumIsOffByMoreThanHalfAStep) {
  SensorErrors errors;
  errors.quantisation = {1, 1, 1};
  Readout plain(errors);
  errors.quantisation_carried = true;
  Readout carried(errors);
  Vector3d lost = Vector3d::Zero(), kept = lost, ideal = lost;
  for (int i = 0; i < 1000; ++i) {
    const Vector3d rate(0.3, -0.3, 0.25);
    lost += plain.of(rate);
    kept += carried.of(rate);
    ideal += rate;
    ASSERT_LE((kept - ideal).cwiseAbs().maxCoeff(), 0.5 + 1e-9);
  }
  EXPECT_EQ(lost, Vector3d::Zero());  // a third of a step per sample is always rounded to zero
}

TEST(Readout, ASaturatedAxisCarriesNothingOver) {
  SensorErrors errors;
  errors.quantisation = {1, 0, 0};
  errors.range = {10, 0, 0};
  errors.quantisation_carried = true;
  Readout readout(errors);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(readout.of({50, 0, 0}).x(), 10);
  EXPECT_EQ(readout.of({0, 0, 0}).x(), 0);
}

}  // namespace readout_test
}  // namespace drydock::sensor
