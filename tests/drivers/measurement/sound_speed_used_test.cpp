#include "drivers/measurement/sound_speed_used.hpp"

#include <gtest/gtest.h>

namespace drydock::measurement {

/// A DVL that was set to 1500 m/s.
BottomVelocity sample(std::optional<double> celsius, std::optional<double> salinity_ppt,
                      double depth_m) {
  BottomVelocity sample;
  sample.sound_speed_mps = 1500;
  if (celsius) sample.water_temperature_k = *celsius + melting_point_k;
  sample.salinity_ppt = salinity_ppt;
  sample.depth_m = depth_m;
  return sample;
}

TEST(SoundSpeedUsed, StandsBesideThatOfTheMeanWaterAtTheHead) {
  SoundSpeedUsed sound;
  sound.add(sample(24, 34, 900));
  sound.add(sample(26, 36, 1100));
  const auto means = sound.means();
  ASSERT_TRUE(means);
  EXPECT_EQ(means->samples, 2U);
  EXPECT_NEAR(means->of_water_mps, 1550.744, 5e-4);  // Mackenzie's check value
  EXPECT_NEAR(means->error(), 1500 / 1550.744 - 1, 1e-6);
}

TEST(SoundSpeedUsed, OfFreshWaterComesFromAnEquationThatHoldsThere) {
  SoundSpeedUsed sound;
  sound.add(sample(20, 0, 0));
  // Medwin: 1449.2 + 92 - 22 + 2.32 - 39.9. Del Grosso and Mader 1972 measured 1482.34.
  EXPECT_NEAR(sound.means()->of_water_mps, 1481.62, 1e-6);
  EXPECT_EQ(sound.means()->equation, SoundSpeedEquation::medwin);
}

TEST(SoundSpeedUsed, IsNotKnownWhereTheDvlTellsNoTemperature) {
  SoundSpeedUsed sound;
  sound.add(sample({}, 35, 10));
  EXPECT_FALSE(sound.means());
}

}  // namespace drydock::measurement
