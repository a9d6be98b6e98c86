#include "drivers/diagnosis/monitors/satellite_monitor.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/drivers/diagnosis/signs.hpp"

namespace drydock::diagnosis::satellite_monitor_test {

/// Ten satellites, once a second for a minute.
struct SkyThatIsWatched : testing::Test {
  SkyThatIsWatched() {
    for (int i = 0; i < 60; ++i) see(10, 0);
  }
  void see(unsigned satellites, double stronger_db) {
    measurement::GnssSatellites message;
    message.origin.received_at = at_s(now += 1);
    for (unsigned i = 0; i < satellites; ++i)
      message.satellites.push_back({.number = static_cast<std::uint8_t>(i + 1),
                                    .cno_dbhz = 35.0 + i + stronger_db,
                                    .elevation_rad = {},
                                    .azimuth_rad = {}});
    monitor.take(message);
  }
  Signs signs;
  SatelliteMonitor monitor{0, signs};
  double now = 0;
};

TEST_F(SkyThatIsWatched, MayLoseTwoSatellites) {
  for (int i = 0; i < 60; ++i) see(8, 0);
  EXPECT_TRUE(signs.all.empty());
}

TEST_F(SkyThatIsWatched, LosesHalfOfThemAtOnce) {
  see(5, 0);
  see(5, 0);
  ASSERT_TRUE(signs.has(Sign::satellites_gone));
  EXPECT_NEAR(signs.first(Sign::satellites_gone).value, 0.5, 1e-9);
}

TEST_F(SkyThatIsWatched, IsWeakerByTheLossOfItsAntenna) {
  see(10, -10);
  see(10, -10);
  ASSERT_TRUE(signs.has(Sign::signals_changed));
  EXPECT_NEAR(signs.first(Sign::signals_changed).value, -10, 1e-9);
}

TEST_F(SkyThatIsWatched, MayFadeByThreeDecibels) {
  for (int i = 0; i < 60; ++i) see(10, -3);
  EXPECT_TRUE(signs.all.empty());
}

TEST(SatelliteMonitor, OfAnAntennaThatTurnsTakesItsSwingAsUsual) {
  Signs signs;
  SatelliteMonitor monitor{0, signs};
  const auto swing = [&](double now, double more_db) {
    measurement::GnssSatellites message;
    message.origin.received_at = at_s(now);
    for (unsigned i = 0; i < 10; ++i)
      message.satellites.push_back({.number = static_cast<std::uint8_t>(i + 1),
                                    .cno_dbhz = 35 + 8 * std::sin(now / 2) + more_db,
                                    .elevation_rad = {},
                                    .azimuth_rad = {}});
    monitor.take(message);
  };
  double now = 0;
  while (now < 600) swing(now += 1, 0);
  EXPECT_TRUE(signs.all.empty());
  while (now < 620) swing(now += 1, -15);
  EXPECT_TRUE(signs.has(Sign::signals_changed));
}

TEST_F(SkyThatIsWatched, MayChangeSlowly) {
  for (int minute = 0; minute < 10; ++minute)
    for (int i = 0; i < 60; ++i) see(10, -minute);
  EXPECT_TRUE(signs.all.empty());
}

}  // namespace drydock::diagnosis::satellite_monitor_test
