#include <gtest/gtest.h>

#include "drivers/device/reported.hpp"
#include "tests/drivers/diagnosis/line_that_is_watched.hpp"

/// How many frames a line brings, and what its driver reports of it.
namespace drydock::diagnosis::line_reports_test {

using device::State;

// Ten frames a second; a fifth more are two a second, 16 in the window of 8 s.
TEST_F(LineThatIsWatched, HasTooManyFramesWhenOneInFiveComesTwice) {
  for (int i = 0; i < 40; ++i) look(i % 2 == 0 ? 3 : 4);
  EXPECT_TRUE(signs.has(Sign::repeated));
}

// A third is lost at first and nothing later: what was learned is not the usual number.
TEST_F(LineThatIsWatched, HasNoFramesTooManyWhereFramesWereLostFromTheStart) {
  Signs told;
  LineMonitor lossy{{.kind = measurement::Kind::dvl, .nominal_rate_hz = 10}, told};
  for (int i = 0; i < 400; ++i) {
    now += 0.25;
    health.stream.frames += i < 240 ? 2 : 3;
    health.last_message_at = at_s(now);
    lossy.look(health, at_s(now), false);
  }
  EXPECT_FALSE(told.has(Sign::repeated));
}

/// Two seconds of frames are held and come together, ten times; then all is as before.
TEST_F(LineThatIsWatched, HasNoFramesTooManyBehindThoseThatWereHeld) {
  for (int i = 0; i < 80; ++i) look(i % 8 == 7 ? 24 : 0);
  for (int i = 0; i < 80; ++i) look(3);
  EXPECT_FALSE(signs.has(Sign::repeated));
}

TEST_F(LineThatIsWatched, IsHotForHalfAMinute) {
  health.last_error = device::hot_report;
  look(3);
  EXPECT_TRUE(signs.has(Sign::heat));
  for (int i = 0; i < 130; ++i) look(3);
  signs.all.clear();
  look(3);
  EXPECT_TRUE(signs.all.empty());
}

TEST_F(LineThatIsWatched, HasAnErrorThatItsDeviceReports) {
  for (const std::string_view report : {"node 10: emergency 0x8110, CAN overrun, objects lost",
                                        "node 10 lost: no heartbeat for 3 s", "node 10 was stopped",
                                        "the drive is in fault", "the IMU failed its self-test"}) {
    signs.all.clear();
    health.last_error = report;
    look(3);
    EXPECT_TRUE(signs.has(Sign::error_report)) << report;
    for (int i = 0; i < 130; ++i) look(3);
  }
  health.last_error = std::string_view{"a field is no number; it reads as empty"};
  signs.all.clear();
  look(3);
  EXPECT_TRUE(signs.all.empty());
}

TEST_F(LineThatIsWatched, ThatComesBackFromASilenceHasNoErrorOfItsOwn) {
  health.state = State::stale;
  look(0);
  health.last_error = std::string_view{"node 10 has restarted"};
  health.state = State::streaming;
  look(3);
  EXPECT_FALSE(signs.has(Sign::error_report));
}

TEST_F(LineThatIsWatched, RefusesASettingForAMinute) {
  health.last_error = std::string_view{"the DVL refuses \"wcs,1480\""};
  look(3);
  EXPECT_TRUE(signs.has(Sign::refuses));
  for (int i = 0; i < 250; ++i) look(3);
  signs.all.clear();
  look(3);
  EXPECT_TRUE(signs.all.empty());
}

TEST_F(LineThatIsWatched, HasAnotherRateThanStatedAfterTwentySecondsOfIt) {
  health.rate_hz = 0.6 * 10;
  for (int i = 0; i < 75; ++i) look(3);
  EXPECT_FALSE(signs.has(Sign::rate_unexpected));
  for (int i = 0; i < 10; ++i) look(3);
  EXPECT_TRUE(signs.has(Sign::rate_unexpected));
}

/// Three frames of 50 bytes in a quarter of a second are 600 bytes a second.
TEST(LineOfARate, IsFullWhereItsBytesHaveNoPause) {
  for (const auto& [bytes_per_second, full] : {std::pair(610.0, true), std::pair(960.0, false),
                                               std::pair(0.0, false), std::pair(300.0, false)}) {
    Signs signs;
    LineMonitor monitor{{.kind = measurement::Kind::dvl,
                         .nominal_rate_hz = 50,
                         .line_bytes_per_second = bytes_per_second},
                        signs};
    device::Health health;
    health.state = State::streaming;
    health.rate_hz = 12;
    for (int i = 1; i < 100; ++i) {
      health.stream.frames += 3;
      health.stream.bytes_in += 150;
      health.last_message_at = at_s(0.25 * i);
      monitor.look(health, at_s(0.25 * i));
    }
    EXPECT_TRUE(signs.has(Sign::rate_unexpected));
    EXPECT_EQ(signs.has(Sign::line_full), full) << bytes_per_second;
  }
}

TEST_F(LineThatIsWatched, ThatHadItsRateOnceIsLeftToTheOtherMonitors) {
  health.rate_hz = 0.9 * 10;
  look(3);
  health.rate_hz = 0.5 * 10;
  for (int i = 0; i < 200; ++i) look(3);
  EXPECT_FALSE(signs.has(Sign::rate_unexpected));
}

}  // namespace drydock::diagnosis::line_reports_test
