#include "drivers/wire/j1939/j1939.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "drivers/wire/j1939/j1939_address_claim.hpp"
#include "tests/drivers/wire/can_fixture.hpp"

namespace drydock::wire::j1939 {
namespace j1939_test {

using namespace std::chrono_literals;
using test::frame;
using test::text_of;

constexpr std::uint64_t movable = std::uint64_t{1} << 63;  // arbitrary address capable
constexpr std::uint64_t low_name = 0x1000, high_name = 0x2000;

TEST(J1939, IdentifierSplitsAsTheStandardSays) {
  // 60928 to all, 126720 to node 0, 128267 broadcast. canboat split these identifiers.
  EXPECT_EQ(parse_identifier(0x18EEFF01), (Identifier{6, 60928, 255, 1}));
  EXPECT_EQ(parse_identifier(0x1DEF0023), (Identifier{7, 126720, 0, 35}));
  EXPECT_EQ(parse_identifier(0x0DF50B74), (Identifier{3, 128267, 255, 116}));
  EXPECT_EQ(make_identifier({6, 59904, 35, 1}), 0x18EA2301u);
  EXPECT_EQ(make_identifier({3, 128267, 255, 116}), 0x0DF50B74u);
}

RC_GTEST_PROP(J1939, AnyIdentifierSurvivesBeingTakenApart, ()) {
  const auto id = *rc::gen::inRange<std::uint32_t>(0, 0x20000000);
  RC_ASSERT(make_identifier(parse_identifier(id)) == id);
}

RC_GTEST_PROP(J1939, ANameKeepsAllItsBitsButTheReservedOne, (std::uint64_t value)) {
  constexpr std::uint64_t reserved = std::uint64_t{1} << 48;
  RC_ASSERT(to_value(to_name(value)) == (value & ~reserved));
}

TEST(J1939, ClaimAndRequestAreTheBytesOfRealOnes) {
  Name name;
  name.identity_number = 321561;
  name.manufacturer_code = 135;
  name.function = 130;
  name.vehicle_system = 60;
  name.industry_group = 4;
  name.arbitrary_address_capable = true;
  EXPECT_EQ(text_of(encode(AddressClaimed{35, to_value(name)})), "18EEFF23#19E8E410008278C0");
  EXPECT_EQ(text_of(encode(Request{1, 35, 126996})), "18EA2301#14F001");
}

TEST(J1939, ElevenBitRemoteAndErrorFramesAreNotJ1939) {
  EXPECT_FALSE(identify(frame("123#00")));
  EXPECT_FALSE(identify(frame("18EEFF01#R")));
  EXPECT_FALSE(identify(frame("20000004#0004000000000000")));
}

TEST(AddressClaim, ClaimsAtOnceAndHoldsTheAddressAfter250Ms) {
  AddressClaim node(low_name, 0x80);
  const auto claim = node.start(1s);
  ASSERT_TRUE(claim);
  EXPECT_EQ(text_of(*claim), "18EEFF80#0010000000000000");
  EXPECT_FALSE(node.address());
  ASSERT_EQ(node.deadline(), 1s + 250ms);
  EXPECT_FALSE(node.tick(1s + 249ms));
  EXPECT_FALSE(node.address());
  EXPECT_FALSE(node.tick(1s + 250ms));
  EXPECT_EQ(node.address(), 0x80);
  EXPECT_FALSE(node.deadline());
}

/// Two nodes on one bus: every frame that one sends reaches the other.
struct Bus {
  AddressClaim a, b;
  void exchange(std::optional<CanFrame> from_a, std::optional<CanFrame> from_b,
                AddressClaim::Time now) {
    while (from_a || from_b) {
      const auto to_b = from_a, to_a = from_b;
      from_a = to_a ? a.receive(*to_a, now) : std::nullopt;
      from_b = to_b ? b.receive(*to_b, now) : std::nullopt;
    }
  }
  void run(AddressClaim::Time until) {
    for (AddressClaim::Time now{}; now <= until; now += 10ms) {
      exchange(a.tick(now), std::nullopt, now);
      exchange(std::nullopt, b.tick(now), now);
    }
  }
};

TEST(AddressClaim, TheLowerNameWinsWhicheverStartsFirst) {
  for (const bool low_first : {true, false}) {
    Bus bus{AddressClaim(movable | low_name, 0x80), AddressClaim(movable | high_name, 0x80)};
    if (low_first) {
      bus.exchange(bus.a.start(0ms), std::nullopt, 0ms);
      bus.exchange(std::nullopt, bus.b.start(0ms), 0ms);
    } else {
      bus.exchange(std::nullopt, bus.b.start(0ms), 0ms);
      bus.exchange(bus.a.start(0ms), std::nullopt, 0ms);
    }
    bus.run(1s);
    EXPECT_EQ(bus.a.address(), 0x80);
    EXPECT_EQ(bus.b.address(), 0x81);
  }
}

TEST(AddressClaim, AHolderGivesItsAddressUpToALowerNameThatComesLate) {
  Bus bus{AddressClaim(movable | high_name, 0x80), AddressClaim(movable | low_name, 0x80)};
  bus.exchange(bus.a.start(0ms), std::nullopt, 0ms);
  bus.run(500ms);
  EXPECT_EQ(bus.a.address(), 0x80);
  bus.exchange(std::nullopt, bus.b.start(500ms), 500ms);
  EXPECT_FALSE(bus.a.address());
  bus.run(2s);
  EXPECT_EQ(bus.b.address(), 0x80);
  EXPECT_EQ(bus.a.address(), 0x81);
}

TEST(AddressClaim, TheLoserSkipsAddressesThatOthersHold) {
  AddressClaim node(movable | high_name, 0x80, {0x80, 0x84});
  node.start(0ms);
  node.receive(encode(AddressClaimed{0x81, low_name}), 1ms);
  node.receive(encode(AddressClaimed{0x82, low_name + 1}), 1ms);
  const auto next = node.receive(encode(AddressClaimed{0x80, low_name + 2}), 1ms);
  ASSERT_TRUE(next);
  EXPECT_EQ(decode_address_claimed(*identify(*next), next->payload())->source, 0x83);
}

TEST(AddressClaim, WhoMayNotMoveSaysCannotClaimFromTheNullAddress) {
  AddressClaim node(high_name, 0x80);
  node.start(0ms);
  EXPECT_FALSE(node.receive(encode(AddressClaimed{0x80, low_name}), 10ms));
  EXPECT_TRUE(node.cannot_claim());
  ASSERT_TRUE(node.deadline());
  EXPECT_LE(*node.deadline(), 10ms + 153ms);
  const auto sorry = node.tick(*node.deadline());
  ASSERT_TRUE(sorry);
  EXPECT_EQ(text_of(*sorry), "18EEFFFE#0020000000000000");
  EXPECT_FALSE(node.address());
  EXPECT_FALSE(node.deadline());
}

TEST(AddressClaim, AFullRangeEndsInCannotClaim) {
  AddressClaim node(movable | high_name, 0x80, {0x80, 0x81});
  node.start(0ms);
  node.receive(encode(AddressClaimed{0x81, low_name}), 1ms);
  node.receive(encode(AddressClaimed{0x80, low_name + 1}), 2ms);
  EXPECT_TRUE(node.cannot_claim());
}

TEST(AddressClaim, AnswersRequestsAddressedToItOrToAll) {
  AddressClaim node(low_name, 0x80);
  node.start(0ms);
  node.tick(250ms);
  const std::string claim = "18EEFF80#0010000000000000";
  // From a node that has no address yet (255, as some devices do, and 254), to all and to this
  // node.
  for (const char* request : {"18EAFFFF#00EE00", "18EAFFFE#00EE00", "18EA8001#00EE00"}) {
    const auto answer = node.receive(frame(request), 300ms);
    ASSERT_TRUE(answer) << request;
    EXPECT_EQ(text_of(*answer), claim);
  }
  EXPECT_FALSE(node.receive(frame("18EA8101#00EE00"), 300ms));  // to another node
  EXPECT_FALSE(node.receive(frame("18EAFF01#14F001"), 300ms));  // for another PGN
}

TEST(AddressClaim, AnswersARequestWithCannotClaimWhenItHasNoAddress) {
  AddressClaim node(high_name, 0x80);
  node.start(0ms);
  node.receive(encode(AddressClaimed{0x80, low_name}), 10ms);
  node.tick(*node.deadline());
  node.receive(frame("18EAFF01#00EE00"), 1s);
  ASSERT_TRUE(node.deadline());
  const auto answer = node.tick(*node.deadline());
  ASSERT_TRUE(answer);
  EXPECT_EQ(identify(*answer)->source, null_address);
}

TEST(AddressClaim, ItsOwnFrameLoopedBackIsNoContention) {
  AddressClaim node(low_name, 0x80);
  const auto claim = node.start(0ms);
  EXPECT_FALSE(node.receive(*claim, 1ms));
  node.tick(250ms);
  EXPECT_EQ(node.address(), 0x80);
}

TEST(AddressClaim, SaysNothingBeforeItIsStarted) {
  AddressClaim node(low_name, 0x80);
  EXPECT_FALSE(node.receive(frame("18EAFF01#00EE00"), 0ms));
  EXPECT_FALSE(node.deadline());
}

TEST(AddressClaim, TakesTheAddressThatItIsCommandedTo) {
  AddressClaim node(low_name, 0x80);
  node.start(0ms);
  node.tick(250ms);
  EXPECT_FALSE(node.obey({1, high_name, 0x90}, 1s));  // for another NAME
  EXPECT_FALSE(node.obey({1, low_name, 0x80}, 1s));   // it already has the address
  EXPECT_FALSE(node.obey({1, low_name, 0xFE}, 1s));   // no node may have this address
  const auto claim = node.obey({1, low_name, 0x90}, 1s);
  ASSERT_TRUE(claim);
  EXPECT_EQ(text_of(*claim), "18EEFF90#0010000000000000");
  EXPECT_FALSE(node.address());
  node.tick(1250ms);
  EXPECT_EQ(node.address(), 0x90);
}

TEST(AddressClaim, ACommandEndsCannotClaim) {
  AddressClaim node(high_name, 0x80);
  node.start(0ms);
  node.receive(encode(AddressClaimed{0x80, low_name}), 10ms);
  ASSERT_TRUE(node.cannot_claim());
  ASSERT_TRUE(node.obey({1, high_name, 0x90}, 1s));
  node.tick(1250ms);
  EXPECT_EQ(node.address(), 0x90);
}

/// Any number of nodes on one bus: every frame from one reaches all others, in order.
struct Crowd {
  std::vector<AddressClaim> nodes;
  AddressClaim::Time now{};
  void say(std::size_t from, const std::optional<CanFrame>& f) {
    if (!f) return;
    for (std::size_t to = 0; to < nodes.size(); ++to) {
      if (to != from) say(to, nodes[to].receive(*f, now));
    }
  }
  void run(AddressClaim::Time duration) {
    for (const auto end = now + duration; now < end; now += 1ms) {
      for (std::size_t i = 0; i < nodes.size(); ++i) say(i, nodes[i].tick(now));
    }
  }
};

RC_GTEST_PROP(AddressClaim, GivenAnyCrowdEachEndsWithItsOwnAddressOrNone, ()) {
  const auto names = *rc::gen::unique<std::vector<std::uint64_t>>(
      8, rc::gen::inRange<std::uint64_t>(1, 1'000'000));
  Crowd crowd;
  for (const auto name : names) {
    const auto preferred = static_cast<std::uint8_t>(*rc::gen::inRange(0x80, 0x84));
    const std::uint64_t capable = *rc::gen::arbitrary<bool>() ? movable : 0;
    crowd.nodes.emplace_back(capable | name, preferred, AddressRange{0x80, 0x85});
  }
  for (std::size_t i = 0; i < crowd.nodes.size(); ++i) {
    crowd.say(i, crowd.nodes[i].start(crowd.now));
    crowd.run(std::chrono::milliseconds(*rc::gen::inRange(0, 400)));
  }
  crowd.run(3s);
  std::map<std::uint8_t, int> holders;
  for (const auto& node : crowd.nodes) {
    RC_ASSERT(node.address().has_value() != node.cannot_claim());
    if (node.address()) RC_ASSERT(++holders[*node.address()] == 1);
  }
}

RC_GTEST_PROP(AddressClaim, ANodeNeverHoldsAnAddressAgainstALowerName, ()) {
  AddressClaim node(movable | 500, 0x80, {0x80, 0x83});
  AddressClaim::Time now{};
  node.start(now);
  const auto steps = *rc::gen::inRange(0, 40);
  for (int i = 0; i < steps; ++i) {
    now += std::chrono::milliseconds(*rc::gen::inRange(0, 300));
    node.tick(now);
    const auto source = static_cast<std::uint8_t>(*rc::gen::inRange(0x80, 0x85));
    const auto name = movable | *rc::gen::inRange<std::uint64_t>(1, 1000);
    node.receive(encode(AddressClaimed{source, name}), now);
    if (name < (movable | 500)) {
      RC_ASSERT(node.address() != source);
    }
    RC_ASSERT(node.address().has_value() + node.cannot_claim() <= 1);
  }
}

}  // namespace j1939_test
}  // namespace drydock::wire::j1939
