#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <random>

#include "drivers/wire/can/can_bits.hpp"
#include "tests/drivers/diagnosis/bus_that_is_watched.hpp"

namespace drydock::diagnosis::bus_monitor_test {

TEST_F(BusThatIsWatched, HasNoSignWhileItIsSound) {
  for (int i = 0; i < 10'000; ++i) tenth();
  EXPECT_TRUE(signs.all.empty());
}

// 111 bits of an 11-bit frame at 250 kbit/s: half of the bus are 1126 frames a second.
TEST_F(BusThatIsWatched, IsTakenByAnIdentifierThatWasNotThere) {
  for (int i = 0; i < 10; ++i) {
    for (int k = 0; k < 112; ++k) take(frame_of(0x7FF, false), 0.0008 * k);
    tenth();
  }
  ASSERT_TRUE(signs.has(Sign::bus_taken, depth));
  ASSERT_TRUE(signs.has(Sign::bus_taken, rudder));
  EXPECT_NEAR(signs.first(Sign::bus_taken).value, 0.5, 0.06);
  EXPECT_FALSE(signs.has(Sign::strange_frames));
}

// Nodes do not fall silent together: a recorder did not listen, and its clock may have been set.
TEST_F(BusThatIsWatched, BlamesNoNodeForAPauseOfAll) {
  for (const double pause_s : {1.37, 4.04, 1.2e6, 1.37}) {
    now += pause_s;
    for (int i = 0; i < 300; ++i) tenth();
  }
  EXPECT_TRUE(signs.all.empty());
}

// A frame of 8 bytes has 131 bits: 120 of them in a row take 63 ms, and the rudder waits for them.
TEST_F(BusThatIsWatched, BlamesNoNodeThatWaitsForTheBurstOfAnother) {
  for (int i = 0; i < 60; ++i) {
    tenth();
    now += 0.1;
    for (int k = 0; k < 120; ++k) take(frame_of(id(127'257, 35), true), 131. / 250'000 * k);
    take(frame_of(id(127'245, 36), true), 131. / 250'000 * 120);
    monitor.look(at_s(now + 0.065));
  }
  for (const Sign sign : {Sign::irregular, Sign::swapped, Sign::gaps, Sign::late, Sign::repeated})
    EXPECT_FALSE(signs.has(sign, rudder)) << to_string(sign);
}

/// An inertial unit of CANopen with three frames a hundred times a second, and a node of NMEA 2000
/// whose four frames each 0.1 s go before two of them: its first 11 bits are 23Ch. Who is ready and
/// has the lowest identifier sends, as on a real bus.
struct BusOfFrames {
  static constexpr double bitrate = 250'000;
  struct Frame {
    double ready_s;
    std::uint32_t id;
    bool extended;
  };
  BusOfFrames() {
    Expected unit{.device = 0, .kind = measurement::Kind::imu, .nominal_rate_hz = 100};
    unit.protocol.travels = wire::Travels::as_frames;
    unit.protocol.network = wire::Network::canopen;
    unit.address = 1;
    monitor.emplace(std::vector{unit, BusThatIsWatched::node(1, 36)}, signs);
  }
  /// `jitter_s`: the messages of the second node come later by up to so much, in their order.
  void run(double end_s, double jitter_s) {
    for (; now < end_s; now += 0.01) {
      for (const std::uint32_t id : {0x181U, 0x281U, 0x381U}) waiting.push_back({now, id, false});
      if (tick++ % 10 == 0)
        for (const std::uint32_t pgn : {127'245U, 127'245U, 127'245U, 127'488U}) {
          latest = std::max(latest, now + jitter_s * uniform(random));
          const auto id = wire::j1939::make_identifier({.priority = 2, .pgn = pgn, .source = 36});
          held.push_back({latest, id, true});
        }
      if (tick % 10 == 1)
        for (const std::uint32_t pgn : {127'257U, 128'267U, 130'314U})
          waiting.push_back({now, BusThatIsWatched::id(pgn, 35), true});
      send_until(now + 0.01);
    }
  }
  void send_until(double end_s) {
    while (!held.empty() && held.front().ready_s < end_s) {
      waiting.push_back(held.front());
      held.pop_front();
    }
    while (!waiting.empty()) {
      const double from = std::max(free, std::ranges::min(waiting, {}, &Frame::ready_s).ready_s);
      if (from >= end_s) return;
      const auto priority = [&](const Frame& one) {
        return one.ready_s > from ? 0xFFFFFFFF : one.extended ? one.id : one.id << 18;
      };
      const auto next = std::ranges::min_element(waiting, {}, priority);
      auto frame = frame_of(next->id, next->extended);
      frame.data[0] = ++count;
      free = from + wire::wire_bits(frame) / bitrate;
      monitor->take(frame, at_s(free));
      waiting.erase(next);
      if (count % 64 == 0) monitor->look(at_s(free));
    }
  }
  Signs signs;
  std::optional<BusMonitor> monitor;
  std::vector<Frame> waiting;
  std::deque<Frame> held;
  double now = 0, free = 0, latest = 0;
  long tick = 0;
  std::uint8_t count = 0;
  std::mt19937 random{3};
  std::uniform_real_distribution<double> uniform;
};

TEST(BusWithANodeThatJitters, BlamesTheUnitForNothingWhoseFramesWaitForIt) {
  BusOfFrames bus;
  bus.run(60, 0);
  EXPECT_TRUE(bus.signs.all.empty());
  bus.run(360, 0.2);
  EXPECT_TRUE(bus.signs.has(Sign::irregular, 1));
  for (const Sign sign : {Sign::irregular, Sign::swapped, Sign::gaps, Sign::late, Sign::repeated})
    EXPECT_FALSE(bus.signs.has(sign, 0)) << to_string(sign);
}

TEST_F(BusThatIsWatched, BlamesANodeThatComesLateWhileTheOtherGoesOn) {
  for (int i = 0; i < 14; ++i) {
    now += 0.1;
    take(frame_of(id(127'245, 36), true), 0.001);
    monitor.look(at_s(now + 0.002));
  }
  now += 0.037;
  for (int i = 0; i < 100; ++i) tenth();
  EXPECT_TRUE(signs.has(Sign::late, depth));
}

// 128 identifiers can be kept.
TEST(BusWithManyIdentifiers, HasNoneOfWhichItIsKnownThatItIsNew) {
  Signs signs;
  BusMonitor monitor{{BusThatIsWatched::node(depth, 35), BusThatIsWatched::node(rudder, 36)},
                     signs};
  for (int i = 0; i < 50'000; ++i) {
    const auto source = static_cast<std::uint8_t>(i % 200);
    monitor.take(frame_of(BusThatIsWatched::id(127'257, source), true), at_s(0.002 * i));
    if (i % 125 == 0) monitor.look(at_s(0.002 * i));
  }
  EXPECT_FALSE(signs.has(Sign::strange_frames));
  EXPECT_FALSE(signs.has(Sign::bus_taken));
}

// What is usual is learned for 30 s of what was heard: a second, a long hole, and the rest.
TEST(BusWithAHole, LearnsItsIdentifiersBehindIt) {
  Signs signs;
  BusMonitor monitor{{BusThatIsWatched::node(depth, 35), BusThatIsWatched::node(rudder, 36)},
                     signs};
  const auto take = [&](double at, std::uint32_t pgn, std::uint8_t source) {
    monitor.take(frame_of(BusThatIsWatched::id(pgn, source), true), at_s(at));
    monitor.look(at_s(at));
  };
  for (int i = 0; i < 10; ++i) take(0.1 * i, 127'257, 35);
  for (int i = 0; i < 1000; ++i) take(1e6 + 0.05 * i, i % 3 == 0 ? 127'257 : 127'245, 36);
  EXPECT_FALSE(signs.has(Sign::strange_frames));
  EXPECT_FALSE(signs.has(Sign::bus_taken));
}

TEST_F(BusThatIsWatched, TakesANodeThatJoinsForNoFault) {
  for (int i = 0; i < 600; ++i) {
    take(frame_of(id(130'306, 50), true), 0.01);
    tenth();
  }
  EXPECT_TRUE(signs.all.empty());
}

// NMEA 2000: a heartbeat (126993) comes every 60 s, product information (126996) when asked for.
TEST_F(BusThatIsWatched, HasNodesThatSaySomeThingsForTheFirstTimeAfterAMinute) {
  for (const std::uint8_t source : {35, 36}) {
    take(frame_of(id(126'993, source), true), 0.01);
    take(frame_of(id(126'996, source), true), 0.02);
    tenth();
  }
  EXPECT_TRUE(signs.all.empty());
}

TEST_F(BusThatIsWatched, KnowsWhoSendsNoiseByWhatFollowsIt) {
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    tenth();
    if (i % 4 == 0) take(frame_of(random() & 0x1FFFFFFF, true), 0.0995);
  }
  tenth();
  EXPECT_TRUE(signs.has(Sign::strange_frames, depth));
  EXPECT_FALSE(signs.has(Sign::strange_frames, rudder));
}

TEST_F(BusThatIsWatched, KnowsWhoseFramesAreShorter) {
  take(frame_of(id(127'245, 36), true, 3), 0.05);
  EXPECT_TRUE(signs.has(Sign::bad_checksums, rudder));
  EXPECT_FALSE(signs.has(Sign::bad_checksums, depth));
}

TEST_F(BusThatIsWatched, IsOffUntilAFrameComes) {
  wire::CanFrame off = frame_of(0x040, false);
  off.error = true;
  take(off, 0.01);
  monitor.look(at_s(now + 3));
  EXPECT_TRUE(signs.has(Sign::bus_off, depth));
  EXPECT_TRUE(signs.has(Sign::bus_off, rudder));
  signs.all.clear();
  tenth();
  EXPECT_FALSE(signs.has(Sign::bus_off));
}

/// Two rudders at one address: every other frame comes right behind the one before it.
TEST_F(BusThatIsWatched, MayHaveANodeThatSendsTwoOrFourFramesOfOneKindTogether) {
  for (const int frames : {2, 4}) {
    BusMonitor alone{{node(rudder, 36)}, signs};
    for (int i = 0; i < 6000; ++i)
      for (int k = 0; k < frames; ++k) {
        auto frame = frame_of(id(127'245, 36), true);
        frame.data[0] = ++count;
        alone.take(frame, at_s(0.1 * i + 0.001 * k));
        alone.look(at_s(0.1 * i + 0.001 * k));
      }
    EXPECT_TRUE(signs.all.empty()) << frames;
  }
}

TEST_F(BusThatIsWatched, HasFramesThatComeTwice) {
  for (int i = 0; i < 30; ++i) {
    tenth();
    if (i % 4 != 0) continue;
    --count;
    take(frame_of(id(127'245, 36), true), 0.0015);
  }
  EXPECT_TRUE(signs.has(Sign::repeated, rudder));
  EXPECT_FALSE(signs.has(Sign::repeated, depth));
}

/// A node of a slow clock pushes the frames of another ahead of it. The other is no drifter, also
/// when the first is sound again and the slope of the other is not yet.
TEST_F(BusThatIsWatched, LaysADriftToTheNodeThatDriftsFirst) {
  for (int i = 0; i < 400; ++i) tenth();
  const double from = now;
  for (int i = 0; i < 1000; ++i) {
    now += 0.1;
    const double drifted_s = std::min(now - from, 40.0);
    take(frame_of(id(127'257, 35), true), 60e-6 * drifted_s);
    take(frame_of(id(127'245, 36), true), 0.001 + 60e-6 * std::clamp(now - from - 6, 0.0, 40.0));
    monitor.look(at_s(now + 0.05));
  }
  EXPECT_TRUE(signs.has(Sign::clock_drift, depth));
  EXPECT_FALSE(signs.has(Sign::clock_drift, rudder));
}

}  // namespace drydock::diagnosis::bus_monitor_test
