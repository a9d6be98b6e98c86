#include "drivers/diagnosis/monitors/line_monitor.hpp"

#include "tests/drivers/diagnosis/line_that_is_watched.hpp"

namespace drydock::diagnosis::line_monitor_test {

using device::State;

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

}  // namespace drydock::diagnosis::line_monitor_test
