#include "drivers/device/life_cycle.hpp"

#include <gmock/gmock.h>

#include <vector>

#include "tests/drivers/device/support.hpp"

namespace drydock::device::test {
namespace life_cycle_test {

using testing::EndsWith;
using namespace std::chrono_literals;

LifeCycleOptions line_options() { return {}; }

LifeCycleOptions bus_options() {
  LifeCycleOptions options;
  options.reopen_when_quiet = false;
  return options;
}

/// A device in state waiting; its link has been open since 0 s.
LifeCycle waiting(const LifeCycleOptions& options = line_options()) {
  LifeCycle life(options);
  life.start(at_s(0));
  life.opened(at_s(0));
  return life;
}

LifeCycle streaming(const LifeCycleOptions& options = line_options()) {
  LifeCycle life = waiting(options);
  life.message(at_s(0));
  return life;
}

LifeCycle stale(const LifeCycleOptions& options = line_options()) {
  LifeCycle life = streaming(options);
  life.tick(at_s(2));
  return life;
}

TEST(FixedText, ControlCharactersNeverReachATerminal) {
  const Reason reason("\033[2Jok\x7f\r\n\xc3\xa9");
  EXPECT_EQ(reason.view(), "?[2Jok???\xc3\xa9");
}

TEST(LifeCycle, ClosedDeviceWantsNothing) {
  const LifeCycle life;
  EXPECT_EQ(life.state(), State::closed);
  EXPECT_FALSE(life.wants_open());
  EXPECT_FALSE(life.wants_close());
  EXPECT_FALSE(life.deadline());
}

TEST(LifeCycle, StartedDeviceWantsItsLinkOpened) {
  LifeCycle life;
  const auto change = life.start(at_s(1));
  ASSERT_TRUE(change);
  EXPECT_EQ(change->from, State::closed);
  EXPECT_EQ(change->to, State::opening);
  EXPECT_TRUE(life.wants_open());
}

TEST(LifeCycle, FirstMessageMakesItStreamAndFurtherOnesAreNoNews) {
  LifeCycle life = waiting();
  EXPECT_EQ(life.message(at_s(1))->to, State::streaming);
  EXPECT_FALSE(life.message(at_s(1.1)));
  EXPECT_EQ(life.deadline(), at_s(3.1));  // stale 2 s after the last message
}

TEST(LifeCycle, SilenceMakesItStaleAndAMessageMakesItStreamAgain) {
  LifeCycle life = streaming();
  EXPECT_FALSE(life.tick(at_s(1.99)));
  const auto change = life.tick(at_s(2));
  ASSERT_TRUE(change);
  EXPECT_EQ(change->to, State::stale);
  EXPECT_EQ(change->why.view(),
            "no message for 2 s; opening the link again in 10 s if it stays quiet");
  EXPECT_EQ(life.message(at_s(5))->to, State::streaming);
}

TEST(LifeCycle, StaleLineIsClosedAndOpenedAgain) {
  LifeCycle life = stale();
  EXPECT_EQ(life.deadline(), at_s(12));
  const auto change = life.tick(at_s(12));
  ASSERT_TRUE(change);
  EXPECT_EQ(change->to, State::backing_off);
  EXPECT_EQ(change->why.view(), "no message for 12 s; retry in 0.25 s");
  EXPECT_TRUE(life.wants_close());
  EXPECT_FALSE(life.link_lost(at_s(12), "closed"));
  EXPECT_FALSE(life.wants_close());
  EXPECT_EQ(life.tick(at_s(12.25))->to, State::opening);
}

TEST(LifeCycle, LineThatNeverSpeaksIsOpenedAgain) {
  LifeCycle life = waiting();
  EXPECT_EQ(life.tick(at_s(10))->to, State::backing_off);
}

TEST(LifeCycle, OpeningASilentLinkAgainBreaksNothing) {
  LifeCycle life = stale();
  life.tick(at_s(12));
  life.link_lost(at_s(12), "closed");
  life.tick(at_s(12.25));
  life.opened(at_s(12.3));
  EXPECT_EQ(life.state(), State::waiting);
  EXPECT_EQ(life.link_up_since(), at_s(0));
  EXPECT_FALSE(life.link_broken_since());
  EXPECT_EQ(life.link_failures(), 0u);
}

TEST(LifeCycle, LinkIsBrokenFromItsLossUntilItCanBeOpened) {
  LifeCycle life = streaming();
  life.link_lost(at_s(5), "hung up");
  life.tick(at_s(5.25));
  life.open_failed(at_s(5.25), "no such port");
  EXPECT_EQ(life.link_broken_since(), at_s(5));
  EXPECT_FALSE(life.link_up_since());
  EXPECT_EQ(life.link_failures(), 2u);
  life.tick(at_s(6));
  life.opened(at_s(6));
  EXPECT_FALSE(life.link_broken_since());
  EXPECT_EQ(life.link_up_since(), at_s(6));
}

TEST(LifeCycle, BackOffDoublesFromAQuarterSecondToOneSecond) {
  LifeCycle life;
  Stamp now = at_s(0);
  life.start(now);
  std::vector<double> waits;
  for (int i = 0; i < 5; ++i) {
    life.open_failed(now, "no such device");
    waits.push_back(measurement::seconds(*life.deadline() - now));
    now = *life.deadline();
    life.tick(now);
  }
  EXPECT_EQ(waits, (std::vector<double>{0.25, 0.5, 1, 1, 1}));
  EXPECT_EQ(now, at_s(3.75));
}

TEST(LifeCycle, OnlyStreamingForgivesEarlierFailures) {
  LifeCycle life;
  life.start(at_s(0));
  life.open_failed(at_s(0), "busy");
  life.tick(at_s(0.25));
  life.opened(at_s(0.25));
  life.link_lost(at_s(1), "unplugged");
  EXPECT_EQ(life.deadline(), at_s(1.5));  // it opened but never streamed: the second back-off
  life.tick(at_s(1.5));
  life.opened(at_s(1.5));
  life.message(at_s(2));
  life.link_lost(at_s(3), "unplugged");
  EXPECT_EQ(life.deadline(), at_s(3.25));
}

TEST(LifeCycle, TheReasonSaysWhatHappenedAndWhatComesNext) {
  LifeCycle life = streaming();
  life.link_lost(at_s(1), "first");
  life.tick(at_s(1.25));
  const auto change = life.open_failed(at_s(1.25), "/dev/ttyUSB0: no such file");
  EXPECT_EQ(change->why.view(), "/dev/ttyUSB0: no such file; retry in 0.5 s");
}

TEST(LifeCycle, QuietBusIsNoFault) {
  LifeCycle life = stale(bus_options());
  EXPECT_FALSE(life.deadline());
  EXPECT_FALSE(life.tick(at_s(3600)));
  EXPECT_EQ(life.state(), State::stale);
  EXPECT_FALSE(life.wants_close());
  EXPECT_EQ(life.status(at_s(3600)).view(), "no message for 3600 s on a bus that is up");
  EXPECT_EQ(life.message(at_s(3601))->to, State::streaming);
}

TEST(LifeCycle, BusDeviceThatNeverSpokeKeepsWaiting) {
  LifeCycle life = waiting(bus_options());
  EXPECT_FALSE(life.tick(at_s(100)));
  EXPECT_EQ(life.state(), State::waiting);
  EXPECT_EQ(life.status(at_s(12.5)).view(), "no message for 12.5 s on a bus that is up");
}

TEST(LifeCycle, SharedBusMayComeUpBeforeItsOwnBackOffEnds) {
  LifeCycle life = streaming(bus_options());
  life.link_lost(at_s(1), "down");
  EXPECT_EQ(life.opened(at_s(1.1))->to, State::waiting);
}

LifeCycleOptions search_options() {
  LifeCycleOptions options;
  options.reopen_in_place = true;
  return options;
}

TEST(LifeCycle, LineWhoseRateIsSearchedIsOpenedAgainWithoutAChangeOfState) {
  LifeCycle life = waiting(search_options());
  EXPECT_FALSE(life.tick(at_s(10)));
  EXPECT_TRUE(life.wants_close());
  EXPECT_FALSE(life.wants_open()) << "not before it is closed";
  EXPECT_FALSE(life.link_lost(at_s(10), "closed"));
  EXPECT_FALSE(life.wants_close());
  EXPECT_TRUE(life.wants_open());
  EXPECT_FALSE(life.opened(at_s(10)));
  EXPECT_FALSE(life.wants_open());
  EXPECT_EQ(life.state(), State::waiting);
  EXPECT_EQ(life.deadline(), at_s(20));
  EXPECT_EQ(life.status(at_s(12)).view(), "no message for 12 s; its rate is searched");
  EXPECT_EQ(life.opened_count(), 2U);
  EXPECT_EQ(life.message(at_s(13))->to, State::streaming);
}

TEST(LifeCycle, LineWhoseRateIsSearchedSaysThatItsPortHasGone) {
  LifeCycle life = stale(search_options());
  life.tick(at_s(12));
  life.link_lost(at_s(12), "closed");
  const auto change = life.open_failed(at_s(12), "No such file or directory");
  ASSERT_TRUE(change);
  EXPECT_EQ(change->from, State::stale);
  EXPECT_EQ(change->to, State::backing_off);
  EXPECT_EQ(life.deadline(), at_s(12.25));
}

TEST(LifeCycle, StopClosesFromEveryState) {
  LifeCycle life = streaming();
  EXPECT_EQ(life.stop(at_s(1))->to, State::closed);
  EXPECT_TRUE(life.wants_close());
  EXPECT_FALSE(life.message(at_s(1.1)));
  EXPECT_FALSE(life.link_lost(at_s(1.2), "closed"));
  EXPECT_FALSE(life.wants_close());
  EXPECT_FALSE(life.deadline());
}

TEST(LifeCycle, LongReasonLeavesRoomForWhatComesNext) {
  LifeCycle life;
  life.start(at_s(0));
  const auto change = life.open_failed(at_s(0), std::string(500, 'x'));
  EXPECT_THAT(std::string(change->why.view()), EndsWith("xxx; retry in 0.25 s"));
}

TEST(LifeCycle, OnASharedLinkTheSilenceOfOneDoesNotOpenItAgain) {
  LifeCycle life = streaming();
  life.share_link();
  const auto quiet = life.tick(at_s(2));
  EXPECT_EQ(quiet->to, State::stale);
  EXPECT_THAT(std::string(quiet->why.view()),
              EndsWith("when all devices on it are quiet for 10 s"));
  EXPECT_FALSE(life.deadline());
  EXPECT_EQ(life.gives_up_at(), at_s(12)) << "the shell asks all devices of the link";
  EXPECT_EQ(life.give_up(at_s(12))->to, State::backing_off);
  EXPECT_TRUE(life.wants_close());
}

TEST(LifeCycle, TheSilenceBehindARecordingIsItsEnd) {
  LifeCycle life = streaming(bus_options());
  life.end_of_recording();
  EXPECT_EQ(life.state(), State::streaming);
  const auto end = life.tick(at_s(2));
  EXPECT_EQ(end->to, State::closed);
  EXPECT_EQ(end->why.view(), "end of the recording");
}

}  // namespace life_cycle_test
}  // namespace drydock::device::test
