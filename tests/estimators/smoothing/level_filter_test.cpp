#include "estimators/smoothing/level_filter.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace drydock::smoothing {
namespace {

/// Is a depth used that is seven sigmas away? `state_m`: one sigma of the expected depth,
/// `noise_m`: of the sensor.
bool uses_seven_sigmas(double state_m, double noise_m) {
  LevelOptions options;
  options.gate_sigma = 5;
  options.sigmas.depth_m = state_m;
  LevelFilter filter(options);
  const double away_m = 7 * std::hypot(state_m, noise_m);
  Reading reading;
  reading.quantity = Quantity::depth;
  reading.value.x() = away_m;
  reading.sigma.setConstant(noise_m);
  return filter.update(reading, {})[0].used;
}

// The gate is 5 sigma, and 1.6 * 5 = 8 of what was expected.
TEST(LevelFilter, TakesWhatItExpectedAsLessCertainAtItsGateSoThatTurnsMayBegin) {
  EXPECT_TRUE(uses_seven_sigmas(10, 0.1));
}

TEST(LevelFilter, TakesTheNoiseOfASensorAsItIsAtItsGate) {
  EXPECT_FALSE(uses_seven_sigmas(0.1, 10));
}

}  // namespace
}  // namespace drydock::smoothing
