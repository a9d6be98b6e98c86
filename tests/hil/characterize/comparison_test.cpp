#include "hil/characterize/compare/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hil/sensor/random.hpp"

namespace drydock::characterize {
namespace comparison_test {

/// A speed that varies like that of a vehicle on its legs.
double speed(double t) { return 2 + 0.8 * std::sin(t / 20) + 0.3 * std::sin(t / 7); }

TEST(Comparison, ScaleBiasAndDelayComeBackThroughBothSensorsNoise) {
  sensor::RandomStream random(3, "pair", "noise");
  Signal sensor, reference;
  for (int k = 0; k < 2400; ++k) {
    const double t = k * 0.5;
    sensor.t_s.push_back(t);
    sensor.value.push_back(1.03 * speed(t - 0.2) + 0.1 + 0.03 * random.normal());
  }
  for (int k = 0; k < 6000; ++k) {
    const double t = k * 0.2;
    reference.t_s.push_back(t);
    reference.value.push_back(speed(t) + 0.2 * random.normal());
  }
  const auto found = compare(sensor, reference).value();
  ASSERT_TRUE(found.scale && found.delay_s);
  EXPECT_TRUE(found.scale->holds(1.03)) << found.scale->value;
  EXPECT_TRUE(found.bias.holds(0.1)) << found.bias.value;
  EXPECT_LT(found.scale->high - found.scale->low, 0.03);
  EXPECT_NEAR(found.delay_s->value, 0.2, 0.1);
}

TEST(Comparison, AReferenceThatHardlyMovesGivesABiasAndNoScale) {
  sensor::RandomStream random(4, "pair", "noise");
  Signal sensor, reference;
  for (int k = 0; k < 1000; ++k) {
    sensor.t_s.push_back(k);
    sensor.value.push_back(5.5 + 0.1 * random.normal());
    reference.t_s.push_back(k);
    reference.value.push_back(5 + 0.1 * random.normal());
  }
  const auto found = compare(sensor, reference).value();
  EXPECT_FALSE(found.scale);
  EXPECT_TRUE(found.bias.holds(0.5));
}

TEST(Comparison, OfSignalsThatShareNoTimeThereIsNone) {
  Signal early, late;
  for (int k = 0; k < 100; ++k) {
    early.t_s.push_back(k);
    late.t_s.push_back(1000 + k);
    early.value.push_back(k);
    late.value.push_back(k);
  }
  EXPECT_FALSE(compare(early, late));
  EXPECT_FALSE(compare({}, {}));
}

}  // namespace comparison_test
}  // namespace drydock::characterize
