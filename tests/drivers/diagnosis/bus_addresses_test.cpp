#include "tests/drivers/diagnosis/bus_that_is_watched.hpp"

/// Two nodes of a bus that claim one address.
namespace drydock::diagnosis::bus_addresses_test {

TEST_F(BusThatIsWatched, HasAnAddressWithTwoOwners) {
  const auto claim = [&](std::uint8_t name) {
    wire::CanFrame frame = frame_of(id(wire::j1939::address_claim_pgn | 0xFF, 35), true);
    frame.data[7] = name;
    monitor.take(frame, at_s(now));
  };
  claim(0xC0);
  tenth();
  EXPECT_FALSE(signs.has(Sign::address_taken));
  claim(0x80);
  tenth();
  EXPECT_TRUE(signs.has(Sign::address_taken, depth));
  EXPECT_FALSE(signs.has(Sign::address_taken, rudder));
}

// J1939-81: who loses his address claims another, and sends from there.
TEST_F(BusThatIsWatched, LaysFramesFromNewAddressesToTheNodeWhoseAddressIsTaken) {
  for (const std::uint8_t name : {0xC0, 0x80}) {
    wire::CanFrame claim = frame_of(id(wire::j1939::address_claim_pgn | 0xFF, 35), true);
    claim.data[0] = name;
    monitor.take(claim, at_s(now + 0.01));
  }
  for (const std::uint8_t address : {128, 129, 130, 131}) {
    now += 0.1;
    take(frame_of(id(127'257, address), true));
    take(frame_of(id(127'245, 36), true), 0.001);  // right behind them, by chance
    monitor.look(at_s(now + 0.002));
  }
  EXPECT_TRUE(signs.has(Sign::address_taken, depth));
  EXPECT_FALSE(signs.has(Sign::strange_frames, rudder));
}

/// A rig need not state the address of its only node; a claim of an address from which nobody sends
/// data is not about it.
TEST_F(BusThatIsWatched, HasTwoOwnersOfAnAddressThatTheRigDoesNotState) {
  BusMonitor alone{{node(depth, 0)}, signs};
  const auto claim = [&](std::uint8_t address, std::uint8_t name) {
    wire::CanFrame frame = frame_of(id(wire::j1939::address_claim_pgn | 0xFF, address), true);
    frame.data[7] = name;
    alone.take(frame, at_s(now));
    alone.look(at_s(now));
  };
  claim(35, 0xC0);
  alone.take(frame_of(id(127'257, 35), true), at_s(now));
  claim(90, 0xB0);
  claim(90, 0x90);
  EXPECT_FALSE(signs.has(Sign::address_taken));
  claim(35, 0x80);
  EXPECT_TRUE(signs.has(Sign::address_taken, depth));
}

/// J1939-81: an address is held 250 ms after its claim that nobody contended.
TEST_F(BusThatIsWatched, HasNoTroubleAnyMoreWhenTheNodeHoldsAnotherAddress) {
  std::uint8_t address = 35;
  const auto claim = [&](std::uint8_t at, std::uint8_t name) {
    wire::CanFrame frame = frame_of(id(wire::j1939::address_claim_pgn | 0xFF, at), true);
    frame.data[7] = name;
    monitor.take(frame, at_s(now));
  };
  const auto seconds = [&](int count) {
    for (int i = 0; i < 10 * count; ++i) {
      now += 0.1;
      for (const std::uint32_t pgn : {127'250, 127'251, 127'257, 128'267})
        take(frame_of(id(pgn, address), true));
      take(frame_of(id(127'245, 36), true), 0.001);
      monitor.look(at_s(now + 0.002));
    }
  };
  claim(35, 0xC0);
  claim(35, 0x80);
  monitor.look(at_s(now + 0.1));
  EXPECT_TRUE(signs.has(Sign::address_taken, depth));
  claim(address = 128, 0xC0);
  for (int i = 0; i < 3; ++i) {  // it is silent while it claims
    now += 0.1;
    take(frame_of(id(127'245, 36), true), 0.001);
  }
  seconds(1);
  signs.all.clear();
  seconds(20);
  EXPECT_TRUE(signs.all.empty()) << "it has moved";
  claim(35, 0x80);
  seconds(1);
  EXPECT_TRUE(signs.all.empty()) << "the other has that address now";
  claim(128, 0x70);
  monitor.look(at_s(now + 0.1));
  EXPECT_TRUE(signs.has(Sign::address_taken, depth)) << "that one is taken as well";
}

TEST_F(BusThatIsWatched, HasANodeWithoutAnAddressAsLongAsItFindsNone) {
  const auto claim = [&](std::uint8_t at, std::uint8_t name) {
    wire::CanFrame frame = frame_of(id(wire::j1939::address_claim_pgn | 0xFF, at), true);
    frame.data[7] = name;
    monitor.take(frame, at_s(now));
  };
  claim(35, 0xC0);
  claim(35, 0x80);
  claim(254, 0xC0);  // it cannot claim
  now += 60;
  monitor.look(at_s(now));
  EXPECT_TRUE(signs.has(Sign::address_taken, depth));
}

// Node 36 had lost its address to another that is off now. So nobody answers when 35 claims it.
TEST_F(BusThatIsWatched, HasNoTroubleWhereANodeMovesToTheAddressOfOneThatHasGone) {
  const auto claim = [&](std::uint8_t at, std::uint8_t name) {
    wire::CanFrame frame = frame_of(id(wire::j1939::address_claim_pgn | 0xFF, at), true);
    frame.data[7] = name;
    monitor.take(frame, at_s(now += 0.01));
  };
  claim(36, 0xC0);
  claim(36, 0x80);
  claim(37, 0xC0);
  now += 60;
  claim(35, 0xC1);
  claim(35, 0x81);
  claim(36, 0xC1);
  monitor.look(at_s(now += 0.2));
  EXPECT_TRUE(signs.has(Sign::address_taken, depth)) << "an answer may come";
  monitor.look(at_s(now += 0.1));
  signs.all.clear();
  monitor.look(at_s(now += 0.1));
  EXPECT_FALSE(signs.has(Sign::address_taken, depth));
}

}  // namespace drydock::diagnosis::bus_addresses_test
