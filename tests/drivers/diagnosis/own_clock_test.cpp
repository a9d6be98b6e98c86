#include <gtest/gtest.h>

#include "drivers/diagnosis/monitors/time_monitor.hpp"
#include "tests/drivers/diagnosis/signs.hpp"

/// What a device's own time says beside its arrivals.
namespace drydock::diagnosis::own_clock_test {

/// A device that tells its own time, at 5 Hz.
struct WithAClock : testing::Test {
  WithAClock() {
    for (int i = 0; i < 200; ++i) come(0, 0);
  }
  void come(double late_s, double clock_ahead_s, double age_s = 0.08) {
    now += 0.2;
    measurement::Origin origin;
    origin.received_at = at_s(now + late_s);
    origin.valid_at = at_s(now + late_s - age_s);
    origin.device_time = measurement::from_seconds(now + clock_ahead_s);
    monitor.take(1, origin, false);
  }
  Signs signs;
  TimeMonitor monitor{{.kind = measurement::Kind::dvl,
                       .protocol = {.clock = wire::DeviceClock::yes},
                       .nominal_rate_hz = 5},
                      signs};
  double now = 0;
};

TEST_F(WithAClock, StepsWithItsClock) {
  for (int i = 0; i < 5; ++i) come(0, 10);
  ASSERT_TRUE(signs.has(Sign::clock_step));
  EXPECT_NEAR(signs.first(Sign::clock_step).value, -10, 1e-6);
  EXPECT_FALSE(signs.has(Sign::late));
}

TEST_F(WithAClock, IsLateAgainstItsClock) {
  for (int i = 0; i < 5; ++i) come(0.5, 0);
  ASSERT_TRUE(signs.has(Sign::late));
  EXPECT_NEAR(signs.first(Sign::late).value, 0.5, 1e-6);
  EXPECT_FALSE(signs.has(Sign::clock_step));
}

/// Water Linked tells when its values were true and when it sent them.
TEST_F(WithAClock, IsLateWhereItSaysThatItsValuesAreOld) {
  for (int i = 0; i < 5; ++i) come(0, -1.42, 1.5);
  ASSERT_TRUE(signs.has(Sign::late));
  EXPECT_NEAR(signs.first(Sign::late).value, 1.42, 1e-6);
  EXPECT_FALSE(signs.has(Sign::clock_step));
}

/// Two seconds of messages are held and come together.
TEST_F(WithAClock, IsNotLateWhereItsMessagesWereHeld) {
  for (int burst = 0; burst < 5; ++burst)
    for (int i = 9; i >= 0; --i) come(0.2 * i + 0.125, 0);
  EXPECT_FALSE(signs.has(Sign::late));
  EXPECT_FALSE(signs.has(Sign::clock_step));
}

TEST_F(WithAClock, ThatComesTooEarlyIsNotLate) {
  now += 0.3;  // a pause
  for (int i = 0; i < 5; ++i) come(0, 0.2);
  EXPECT_FALSE(signs.has(Sign::late));
  EXPECT_TRUE(signs.has(Sign::clock_step));
}

TEST_F(WithAClock, DoesNotStepWhereItsLastMessageComesAgain) {
  const double last = now;
  for (int i = 0; i < 100; ++i) come(0, last - (now + 0.2));
  EXPECT_FALSE(signs.has(Sign::clock_step));
}

TEST_F(WithAClock, DriftsAndDoesNotStepWhenThatHasAddedUp) {
  for (int i = 0; i < 1500; ++i) {
    come(0, 1e-3 * 0.2 * i);
    monitor.look(at_s(now));
  }
  ASSERT_TRUE(signs.has(Sign::clock_drift));
  EXPECT_NEAR(signs.all.back().value, 1000, 10);
  EXPECT_FALSE(signs.has(Sign::clock_step));
  EXPECT_FALSE(signs.has(Sign::late));
}

/// No change of rate, and nothing that adds up: 50 parts in a million are 0.18 s an hour.
TEST(AClockOfItsOwnRate, HasNoSignInADay) {
  Signs signs;
  TimeMonitor monitor{{.kind = measurement::Kind::dvl,
                       .protocol = {.clock = wire::DeviceClock::yes},
                       .nominal_rate_hz = 2},
                      signs};
  for (int i = 0; i < 2 * 86'400; ++i) {
    const double now = 0.5 * i;
    measurement::Origin origin;
    origin.received_at = at_s(now);
    origin.valid_at = at_s(now - 0.08);
    origin.device_time = measurement::from_seconds(now * (1 - 50e-6));
    monitor.take(1, origin, false);
    monitor.look(at_s(now));
    ASSERT_TRUE(signs.all.empty()) << now << " s";
  }
}

/// A receiver at 1 Hz with its own clock, whose line says more while it has a fix.
struct ReceiverOnALine : testing::Test {
  explicit ReceiverOnALine(std::string_view protocol = "nmea0183")
      : monitor({.kind = measurement::Kind::gnss,
                 .protocol = *wire::find_protocol(protocol),
                 .nominal_rate_hz = 1,
                 .line_bytes_per_second = 960},
                signs) {}
  void SetUp() override { for_seconds(60, 0.5, 1); }
  void for_seconds(int seconds, double after_s, std::uint32_t length) {
    for (int i = 0; i < seconds; ++i) {
      now += 1;
      measurement::Origin origin;
      origin.received_at = at_s(now + after_s);
      origin.device_time = measurement::from_seconds(now);
      monitor.note_length(1, length, origin.received_at);
      monitor.take(1, origin, false);
      monitor.look(origin.received_at);
    }
  }
  Signs signs;
  TimeMonitor monitor;
  double now = 0;
};

/// UBX NAV-SAT at 9600 baud: 12 bytes a satellite.
struct UbxOnALine : ReceiverOnALine {
  static constexpr double satellite_s = 12 * 10 / 9600.;
  UbxOnALine() : ReceiverOnALine("ubx") {}
  void SetUp() override {}
  void for_satellites(int seconds, std::uint32_t satellites) {
    for_seconds(seconds, 0.03 + satellites * satellite_s, 3 + satellites);
  }
};

TEST_F(UbxOnALine, IsLaterWithEachSatelliteThatItFindsAndItsClockDoesNotDrift) {
  for (std::uint32_t satellites = 0; satellites < 10; ++satellites) for_satellites(3, satellites);
  for_satellites(300, 10);
  EXPECT_TRUE(signs.all.empty());
}

TEST_F(UbxOnALine, IsSoonerUnderWaterAndThatIsNoSign) {
  for_satellites(90, 10);
  for (int dive = 0; dive < 50; ++dive) {
    for_satellites(30, 0);
    for_satellites(30, 10);
  }
  EXPECT_TRUE(signs.all.empty());
}

/// A real sky: a satellite comes or goes every three seconds, 12.5 ms on this line.
struct UbxUnderARealSky : UbxOnALine {
  void SetUp() override { for_satellites(90, 10); }
  void for_changes(int changes, double late_s = 0, bool loses = false) {
    for (int i = 0; i < changes; ++i) {
      const std::uint32_t satellites = 9 + i % 2;
      if (loses) now += 1;
      for_seconds(3, 0.03 + satellites * satellite_s + late_s, 3 + satellites);
    }
  }
};

TEST_F(UbxUnderARealSky, HasNoSign) {
  for_changes(1000);
  EXPECT_TRUE(signs.all.empty());
}

TEST_F(UbxUnderARealSky, IsLateAllTheSame) {
  for_changes(10);
  for_changes(10, 0.8);
  EXPECT_TRUE(signs.has(Sign::late) || signs.has(Sign::clock_step));
}

TEST_F(UbxUnderARealSky, LosesMessagesAllTheSame) {
  for_changes(10);
  for_changes(10, 0, true);
  EXPECT_TRUE(signs.has(Sign::gaps));
}

TEST_F(UbxOnALine, DriftsIfItsClockDoesAfterAllSatellitesAreFound) {
  for_satellites(90, 10);
  for (int i = 0; i < 60; ++i) for_seconds(1, 0.155 + 1e-3 * i, 13);
  ASSERT_TRUE(signs.has(Sign::clock_drift));
  EXPECT_NEAR(signs.all.back().value, -1000, 10);
}

TEST_F(ReceiverOnALine, IsSoonerWithoutItsFixAndThatIsNoSign) {
  for (int dive = 0; dive < 50; ++dive) {
    for_seconds(30, 0.2, 2);
    for_seconds(30, 0.5, 1);
  }
  EXPECT_TRUE(signs.all.empty());
}

TEST_F(ReceiverOnALine, IsLateIfItSaysTheSameLater) {
  for_seconds(30, 0.8, 1);
  EXPECT_TRUE(signs.has(Sign::late) || signs.has(Sign::clock_step));
}

}  // namespace drydock::diagnosis::own_clock_test
