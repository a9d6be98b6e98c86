// Other disturbances on a bus. Error classes are from linux/can/error.h, the address claim from SAE
// J1939-81: the lower NAME wins.
#include "hil/fault/rogue_node.hpp"

#include <gtest/gtest.h>

#include "drivers/wire/j1939/aceinna.hpp"
#include "drivers/wire/j1939/j1939.hpp"
#include "hil/emulate/can/j1939_node.hpp"
#include "rig_config/fault_vocabulary.hpp"
#include "tests/hil/fault/faults.hpp"

namespace drydock::fault::test {
namespace rogue_node_test {

constexpr unsigned bit_rate = 250'000;

struct Bus final : emulate::Wire {
  void send(wire::Bytes) override { ADD_FAILURE() << "bytes on a bus"; }
  void send(const wire::CanFrame& frame) override { frames.push_back(frame); }
  void unplug() override { cut_off = true; }
  void plug() override { cut_off = false; }
  std::vector<wire::CanFrame> frames;
  bool cut_off = false;
};

struct Bench {
  explicit Bench(const FaultConfig& fault) {
    device.name = "depth";
    device.address = 35;
    schedule->add(fault);
  }
  void run(std::chrono::nanoseconds from, std::chrono::nanoseconds to) {
    if (!node) node.emplace(device, bit_rate, 1, start, schedule);
    for (auto due = node->deadline(); due && *due < start + to; due = node->deadline())
      node->tick(std::max(*due, start + from), bus);
  }
  rig_config::DeviceConfig device;
  std::shared_ptr<Schedule> schedule = std::make_shared<Schedule>(start);
  std::optional<RogueNode> node;
  Bus bus;
};

FaultConfig second_to_second(FaultKind kind, double amount = 0) {
  FaultConfig fault = fault_of(kind, amount);
  fault.start_s = 1;
  fault.for_s = 1;
  return fault;
}

TEST(RogueNode, IsSilentBeforeAndAfterItsFault) {
  for (const auto kind : {FaultKind::babbling, FaultKind::bus_load, FaultKind::error_frames}) {
    Bench bench(second_to_second(kind, 0.5));
    bench.run(0s, 1s);
    EXPECT_TRUE(bench.bus.frames.empty());
    bench.run(1s, 2s);
    EXPECT_FALSE(bench.bus.frames.empty());
    const auto sent = bench.bus.frames.size();
    bench.run(2s, 60s);
    EXPECT_EQ(bench.bus.frames.size(), sent);
  }
}

TEST(RogueNode, AsLoadItTakesItsShareOfTheBus) {
  Bench bench(second_to_second(FaultKind::bus_load, 0.3));
  bench.run(0s, 3s);
  // A frame has 111 bits without stuff bits; 0.3 of 250 kbit/s.
  EXPECT_NEAR(static_cast<double>(bench.bus.frames.size()), 0.3 * bit_rate / 111, 2);
}

TEST(RogueNode, BabblesAtTheHighestPriorityWithoutAPause) {
  Bench bench(second_to_second(FaultKind::babbling));
  bench.run(0s, 3s);
  EXPECT_GE(bench.bus.frames.size(), std::size_t{bit_rate / 111});
  for (const auto& frame : bench.bus.frames) ASSERT_EQ(frame.id, 0u);
}

TEST(RogueNode, BusOffIsToldOnceCutsTheDriversOffAndEndsWithARestart) {
  Bench bench(second_to_second(FaultKind::bus_off));
  bench.run(0s, 2s - 1ns);
  ASSERT_EQ(bench.bus.frames.size(), 1u);
  EXPECT_TRUE(bench.bus.frames[0].error);
  EXPECT_EQ(bench.bus.frames[0].id, 0x40u) << "CAN_ERR_BUSOFF";
  EXPECT_TRUE(bench.bus.cut_off);
  bench.run(2s, 3s);
  ASSERT_EQ(bench.bus.frames.size(), 2u);
  EXPECT_EQ(bench.bus.frames[1].id, 0x100u) << "CAN_ERR_RESTARTED";
  EXPECT_FALSE(bench.bus.cut_off);
}

TEST(RogueNode, TakesTheDevicesAddressWithALowerNameAndDefendsIt) {
  Bench bench(second_to_second(FaultKind::address_stolen));
  bench.run(0s, 2s - 1ns);
  ASSERT_EQ(bench.bus.frames.size(), 1u);
  // J1939-81: PGN 60928 (EE00h) to all, priority 6, the claimant's address in the last byte.
  EXPECT_EQ(bench.bus.frames[0].id, 0x18EE'FF23u);

  const wire::j1939::AddressClaimed of_device{.source = 35, .name = 0x8000'0000'0000'0000};
  bench.node->receive(wire::j1939::encode(of_device), start + 1900ms, bench.bus);
  ASSERT_EQ(bench.bus.frames.size(), 2u) << "it says again that the address is its own";
  bench.run(2s, 3s);
  bench.node->receive(wire::j1939::encode(of_device), start + 2500ms, bench.bus);
  EXPECT_EQ(bench.bus.frames.size(), 2u) << "it has gone";
}

/// A node that may choose its address gets a third one, whoever steals the first two.
TEST(RogueNode, LeavesTheOtherAddressesToADeviceWhenTwoSteal) {
  using wire::j1939::AddressClaim;
  Bench first(second_to_second(FaultKind::address_stolen));
  Bench second(second_to_second(FaultKind::address_stolen));
  first.device.name = "log";
  first.device.address = 128;
  second.device.address = 129;
  first.run(0s, 2s - 1ns);
  second.run(0s, 2s - 1ns);
  const auto name = emulate::name_for(second.device, 130, 75);
  AddressClaim victim(wire::j1939::to_value(name), 129);
  ASSERT_TRUE(victim.start(0ms));
  EXPECT_FALSE(victim.tick(250ms));
  EXPECT_FALSE(victim.receive(first.bus.frames.at(0), 1000ms)) << "not its address";
  const auto moved = victim.receive(second.bus.frames.at(0), 1000ms);
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->id & 0xFF, 130u);
}

TEST(RogueNode, TakesTheAddressThatTheDeviceClaimedIfTheRigStatesNone) {
  for (const std::uint8_t address : {0x23, 0x80}) {
    Bench bench(second_to_second(FaultKind::address_stolen));
    bench.device.address = 0;
    bench.run(0s, 500ms);
    auto name = emulate::name_for(bench.device, 130, 75);
    const wire::j1939::AddressClaimed other{.source = 50, .name = 0x1234};
    const wire::j1939::AddressClaimed of_device{.source = address,
                                                .name = wire::j1939::to_value(name)};
    const wire::j1939::AddressClaimed gone{.source = 254, .name = of_device.name};
    for (const auto& claim : {of_device, other, gone})
      bench.node->receive(wire::j1939::encode(claim), start + 250ms, bench.bus);
    EXPECT_TRUE(bench.bus.frames.empty());
    bench.run(500ms, 2s - 1ns);
    ASSERT_EQ(bench.bus.frames.size(), 1u);
    EXPECT_EQ(bench.bus.frames[0].id, 0x18EE'FF00u | address);
  }
}

TEST(RogueNode, WaitsForTheFirstClaimOfADeviceWithoutAnAddress) {
  Bench bench(second_to_second(FaultKind::address_stolen));
  bench.device.address = 0;
  bench.device.protocol = wire::Aceinna::name;
  bench.run(0s, 1500ms);
  EXPECT_TRUE(bench.bus.frames.empty()) << "it does not take address 0";
  const auto name = wire::aceinna::to_value(emulate::name_for(bench.device, 131, 0));
  bench.node->receive(
      wire::j1939::encode(wire::j1939::AddressClaimed{.source = 0x80, .name = name}),
      start + 1600ms, bench.bus);
  ASSERT_EQ(bench.bus.frames.size(), 1u);
  EXPECT_EQ(bench.bus.frames[0].id, 0x18EE'FF80u);
}

}  // namespace rogue_node_test
}  // namespace drydock::fault::test
