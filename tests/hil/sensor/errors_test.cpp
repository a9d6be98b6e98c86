#include "hil/sensor/errors.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace drydock::sensor {
namespace {

constexpr rig_config::SensorErrors errors{{0.1, -0.2, 0.3}, {1, 2, 3}};

TEST(Errors, AFixedBiasIsOneSigmaAsGiven) {
  const ErrorModel model(errors, true, 7, "imu", "primary");
  EXPECT_EQ(model.bias(), Eigen::Vector3d(0.1, -0.2, 0.3));
}

TEST(Errors, ADrawnBiasHasTheGivenSpreadOverManySeeds) {
  double sum = 0, squares = 0;
  constexpr int n = 20'000;
  for (std::uint64_t seed = 0; seed < n; ++seed) {
    const double z = ErrorModel(errors, false, seed, "imu", "primary").bias().z();
    sum += z / n;
    squares += z * z / n;
  }
  EXPECT_NEAR(sum, 0, 4 * 0.3 / std::sqrt(n));
  EXPECT_NEAR(squares, 0.09, 4 * 0.09 * std::sqrt(2.0 / n));
}

TEST(Errors, NoiseIsWhiteWithTheGivenDeviationPerAxis) {
  ErrorModel model(errors, true, 7, "imu", "primary");
  constexpr int n = 50'000;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero(), squares = mean, lagged = mean, last = mean;
  for (int i = 0; i < n; ++i) {
    const Eigen::Vector3d e = model.apply(Eigen::Vector3d::Zero()) - model.bias();
    mean += e / n;
    squares += e.cwiseProduct(e) / n;
    lagged += e.cwiseProduct(last) / n;
    last = e;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const double sigma = axis + 1;
    EXPECT_NEAR(mean[axis], 0, 4 * sigma / std::sqrt(n));
    EXPECT_NEAR(squares[axis], sigma * sigma, 4 * sigma * sigma * std::sqrt(2.0 / n));
    EXPECT_NEAR(lagged[axis], 0, 4 * sigma * sigma / std::sqrt(n));
  }
}

TEST(Errors, WithoutErrorsNothingChanges) {
  ErrorModel model({}, false, 7, "log", "primary");
  EXPECT_EQ(model.apply(1.25), 1.25);
}

}  // namespace
}  // namespace drydock::sensor
