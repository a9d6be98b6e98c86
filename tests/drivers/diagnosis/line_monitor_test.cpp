#include "drivers/diagnosis/monitors/line_monitor.hpp"

#include <gtest/gtest.h>

#include "drivers/device/reported.hpp"
#include "tests/drivers/diagnosis/signs.hpp"

namespace drydock::diagnosis::line_monitor_test {

using device::State;

/// A device on a serial line at 10 Hz, looked at four times a second.
struct LineThatIsWatched : testing::Test {
  LineThatIsWatched() {
    health.state = State::streaming;
    health.since = health.last_message_at.emplace(at_s(0));
    health.link_up_since = at_s(0);
    for (int i = 0; i < 240; ++i) look(3);
  }
  /// A quarter of a second with so many frames.
  void look(unsigned frames) {
    now += 0.25;
    health.stream.frames += frames;
    health.stream.bytes_in += frames * 50;
    if (frames > 0) health.last_message_at = at_s(now);
    monitor.look(health, at_s(now));
  }
  Signs signs;
  LineMonitor monitor{{.kind = measurement::Kind::dvl, .nominal_rate_hz = 10}, signs};
  device::Health health;
  double now = 0;
};

TEST_F(LineThatIsWatched, HasNoSignWhileItIsSound) { EXPECT_TRUE(signs.all.empty()); }

TEST_F(LineThatIsWatched, IsSilentSinceItsLastMessage) {
  health.state = State::stale;
  const double last = now;
  look(0);
  look(0);
  ASSERT_TRUE(signs.has(Sign::silent));
  EXPECT_EQ(signs.first(Sign::silent).since, at_s(last));
}

TEST_F(LineThatIsWatched, IsNotSilentBecauseThisProgramStoodStill) {
  health.state = State::stale;
  now += 8;
  monitor.interrupt(at_s(now));
  health.stream.bad_checksums = 1;  // the end of what the host's buffers kept
  for (int i = 0; i < 4; ++i) look(0);
  EXPECT_TRUE(signs.all.empty());
  health.state = State::streaming;
  for (int i = 0; i < 40; ++i) look(3);
  EXPECT_TRUE(signs.all.empty());
}

TEST_F(LineThatIsWatched, IsSilentWhereItDoesNotComeBackAfterAStall) {
  health.state = State::stale;
  const double last = now;
  now += 8;
  monitor.interrupt(at_s(now));
  for (int i = 0; i < 12; ++i) look(0);
  ASSERT_TRUE(signs.has(Sign::silent));
  EXPECT_EQ(signs.first(Sign::silent).since, at_s(last));
}

TEST_F(LineThatIsWatched, StaysSilentAtAStallWhereItWasSilentBefore) {
  health.state = State::stale;
  look(0);
  look(0);
  signs.all.clear();
  now += 8;
  monitor.interrupt(at_s(now));
  look(0);
  EXPECT_TRUE(signs.has(Sign::silent));
}

TEST_F(LineThatIsWatched, MayBootForTenSeconds) {
  health.state = State::waiting;
  health.since = health.link_up_since.emplace(at_s(now));
  health.last_message_at.reset();
  for (int i = 0; i < 39; ++i) look(0);
  EXPECT_FALSE(signs.has(Sign::silent));
  for (int i = 0; i < 4; ++i) look(0);
  EXPECT_TRUE(signs.has(Sign::silent));
}

/// The driver opens the link again after ten seconds of silence.
TEST_F(LineThatIsWatched, StaysSilentWhileItsDriverOpensTheLinkAgain) {
  const double last = now;
  for (const State state : {State::stale, State::backing_off, State::opening, State::waiting}) {
    signs.all.clear();
    health.state = state;
    health.since = at_s(now);
    look(0);
    ASSERT_TRUE(signs.has(Sign::silent)) << to_string(state);
    EXPECT_EQ(signs.first(Sign::silent).since, at_s(last));
    EXPECT_FALSE(signs.has(Sign::port_lost));
  }
  signs.all.clear();
  health.state = State::streaming;
  look(3);
  EXPECT_TRUE(signs.all.empty());
}

TEST_F(LineThatIsWatched, ThatNeverSpokeIsSilentWhileItsDriverOpensTheLinkAgain) {
  health.link_up_since = at_s(now);
  health.last_message_at.reset();
  for (const State state : {State::waiting, State::backing_off, State::opening, State::waiting}) {
    health.state = state;
    health.since = at_s(now);
    for (int i = 0; i < 41; ++i) look(0);
    EXPECT_TRUE(signs.has(Sign::silent));
    EXPECT_EQ(signs.first(Sign::silent).since, *health.link_up_since);
    EXPECT_FALSE(signs.has(Sign::port_lost));
    signs.all.clear();
  }
}

TEST_F(LineThatIsWatched, LosesItsPort) {
  health.state = State::backing_off;
  health.link_up_since.reset();
  health.link_broken_since = at_s(now);
  health.link_failures = 1;
  look(0);
  EXPECT_TRUE(signs.has(Sign::port_lost));
  EXPECT_FALSE(signs.has(Sign::silent));
}

TEST_F(LineThatIsWatched, HasDamagedFramesAndNoForeignBytesWithThem) {
  health.stream.bad_checksums += 1;
  health.stream.bytes_skipped += 50;
  look(2);
  EXPECT_TRUE(signs.has(Sign::bad_checksums));
  EXPECT_FALSE(signs.has(Sign::foreign_bytes));
}

TEST_F(LineThatIsWatched, HasForeignBytesWithoutDamage) {
  health.stream.bytes_skipped += 16;
  look(3);
  look(3);
  EXPECT_TRUE(signs.has(Sign::foreign_bytes));
  EXPECT_FALSE(signs.has(Sign::bad_checksums));
}

// What begins and does not end, as in a capture that was cut, stands between no frames.
TEST_F(LineThatIsWatched, HasNoForeignBytesBehindItsLastFrame) {
  health.stream.bytes_skipped += 16;
  look(3);
  for (int i = 0; i < 20; ++i) look(0);
  EXPECT_FALSE(signs.has(Sign::foreign_bytes));
}

TEST_F(LineThatIsWatched, DecodesNothingAfterASecondOfBytes) {
  for (int i = 0; i < 3; ++i) {
    health.stream.bytes_in += 40;
    health.bytes_not_text += 20;
    look(0);
  }
  EXPECT_FALSE(signs.has(Sign::nothing_decodes));
  for (int i = 0; i < 2; ++i) {
    health.stream.bytes_in += 40;
    health.bytes_not_text += 20;
    look(0);
  }
  EXPECT_TRUE(signs.has(Sign::nothing_decodes));
}

/// Frames of 50 bytes, three in a quarter of a second, each with a wrong checksum.
TEST_F(LineThatIsWatched, IsDamagedAndNotAtAWrongRateWhereItsBytesAreDamagedFrames) {
  health.stream.bytes_good = health.stream.frames * 50;
  for (int i = 0; i < 20; ++i) {
    health.stream.bytes_in += 150;
    health.bytes_not_text += 100;
    health.stream.bad_checksums += 3;
    health.stream.bytes_skipped += 150;
    look(0);
  }
  EXPECT_TRUE(signs.has(Sign::bad_checksums));
  EXPECT_FALSE(signs.has(Sign::nothing_decodes));
}

TEST_F(LineThatIsWatched, IsNotSilentWhileDamagedFramesCome) {
  health.state = State::stale;
  health.stream.bad_checksums += 1;
  look(0);
  signs.all.clear();
  for (int i = 0; i < 7; ++i) look(0);
  EXPECT_FALSE(signs.has(Sign::silent));
  for (int i = 0; i < 2; ++i) look(0);
  EXPECT_TRUE(signs.has(Sign::silent));
}

/// At a wrong rate hardly a byte is text. A sensor that waits for a command says nothing else.
TEST_F(LineThatIsWatched, PromptsWhereAllBytesAreText) {
  for (int i = 0; i < 5; ++i) {
    health.stream.bytes_in += 4;
    look(0);
  }
  EXPECT_TRUE(signs.has(Sign::prompts));
  EXPECT_FALSE(signs.has(Sign::nothing_decodes));
}

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

}  // namespace drydock::diagnosis::line_monitor_test
