#include "drivers/measurement/sound_speed.hpp"

#include <gtest/gtest.h>

namespace drydock::measurement {

TEST(SoundSpeed, MackenziesCheckValueIsThatOfHisPaper) {
  EXPECT_NEAR(mackenzie_mps(25, 35, 1000), 1550.744, 5e-4);
}

TEST(SoundSpeed, BothEquationsAgreeWithinTheirAccuracyInTheUpperOcean) {
  for (double t = 2; t <= 30; t += 4)
    for (double salinity = 25; salinity <= 40; salinity += 5)
      for (double depth = 0; depth <= 1000; depth += 250)
        EXPECT_NEAR(mackenzie_mps(t, salinity, depth), medwin_mps(t, salinity, depth), 0.6)
            << t << " deg C, " << salinity << " ppt, " << depth << " m";
}

}  // namespace drydock::measurement
