// A CAN bus on its way to the drivers, with faults on one of its devices, in virtual time.
#include "hil/fault/wire/faulty_bus.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rig_config/fault_vocabulary.hpp"
#include "tests/hil/proxy/outlet.hpp"

namespace faulty_bus_test {

using namespace drydock;
using namespace drydock::fault;
using namespace drydock::fault::testing;
using rig_config::FaultTarget;

DeviceConfig node(const std::string& protocol, int address) {
  DeviceConfig device;
  device.name = "imu";
  device.protocol = protocol;
  device.link = "socketcan:can0?bitrate=250000";
  device.address = address;
  return device;
}

wire::CanFrame frame(std::uint32_t id, bool extended, std::uint8_t counter = 0) {
  wire::CanFrame made;
  made.id = id;
  made.extended = extended;
  made.size = 8;
  made.data[0] = counter;
  made.data[7] = 0x5A;
  return made;
}

struct Bench {
  explicit Bench(const DeviceConfig& device)
      : schedule(std::make_shared<Schedule>(start)), bus(device, 250'000, 7, schedule, start) {}

  void run_until(Stamp at) {
    for (auto due = bus.deadline(); due && *due <= at; due = bus.deadline()) {
      now = std::max(now, *due);
      bus.tick(now, heard);
    }
    now = at;
  }
  void say(const wire::CanFrame& frame, Stamp at) {
    run_until(at);
    bus.receive(frame, at, heard);
  }

  std::shared_ptr<Schedule> schedule;
  FaultyBus bus;
  Heard heard;
  Stamp now = start;
};

TEST(DeviceFrames, OfAJ1939NodeAreThoseOfItsSourceAddress) {
  const DeviceFrames frames(node("aceinna", 0x80));
  EXPECT_TRUE(frames.has(frame(0x0CF02A80, true)));
  EXPECT_FALSE(frames.has(frame(0x0CF02A81, true)));
  EXPECT_FALSE(frames.has(frame(0x80, false)));
}

TEST(DeviceFrames, OfACanopenNodeAreWhatItSendsNotWhatItIsSent) {
  const DeviceFrames frames(node("cia404-imu", 5));
  for (const std::uint32_t sent : {0x085u, 0x185u, 0x285u, 0x385u, 0x485u, 0x585u, 0x705u})
    EXPECT_TRUE(frames.has(frame(sent, false))) << std::hex << sent;
  for (const std::uint32_t other : {0x000u, 0x080u, 0x205u, 0x605u, 0x186u, 0x706u})
    EXPECT_FALSE(frames.has(frame(other, false))) << std::hex << other;
}

TEST(DeviceFrames, OfAnXsensAreThoseOfItsIdentifiers) {
  auto device = node("xsens", 0);
  device.xsens.identifiers.push_back({"rate_of_turn", 0x123});
  const DeviceFrames frames(device);
  EXPECT_TRUE(frames.has(frame(0x123, false)));
  EXPECT_TRUE(frames.has(frame(0x34, false)));  // acceleration, default identifier
  EXPECT_FALSE(frames.has(frame(0x32, false)));
}

TEST(DeviceFrames, OfAnUnknownProtocolAreAllButTheControllersWord) {
  const DeviceFrames frames(node("can", 0));
  EXPECT_TRUE(frames.are_all());
  EXPECT_TRUE(frames.has(frame(0x7FF, false)));
  auto error = frame(0x40, false);
  error.error = true;
  EXPECT_FALSE(frames.has(error));
}

TEST(FaultyBus, HitsItsDeviceAloneAndKeepsTheOthersInTheirPlace) {
  Bench bench(node("cia404-imu", 1));
  bench.schedule->add(fault_of("device='imu'\nfault='drop'\nprobability=1.0"));
  bench.say(frame(0x181, false), start + 1ms);
  bench.say(frame(0x182, false), start + 2ms);
  ASSERT_EQ(bench.heard.frames.size(), 1u);
  EXPECT_EQ(bench.heard.frames[0], (Heard::Frame{frame(0x182, false), start + 2ms}));
  EXPECT_EQ(bench.bus.hits()[FaultKind::drop], 1u);
  EXPECT_TRUE(bench.bus.hears());
}

TEST(FaultyBus, OffTheDriversHearAnErrorFrameThenNothingThenThatItIsBack) {
  Bench bench(node("cia404-imu", 1));
  bench.schedule->add(fault_of("device='imu'\nfault='bus-off'\nstart_s=1\nfor_s=1"));
  bench.say(frame(0x182, false), start + 1500ms);
  EXPECT_FALSE(bench.bus.hears());
  bench.say(frame(0x181, false), start + 1600ms);
  bench.say(frame(0x182, false), start + 2500ms);
  EXPECT_TRUE(bench.bus.hears());
  ASSERT_EQ(bench.heard.frames.size(), 3u);
  // linux/can/error.h: CAN_ERR_BUSOFF, CAN_ERR_RESTARTED.
  EXPECT_TRUE(bench.heard.frames[0].frame.error);
  EXPECT_EQ(bench.heard.frames[0].frame.id, 0x040u);
  EXPECT_EQ(bench.heard.frames[0].at, start + 1s);
  EXPECT_EQ(bench.heard.frames[1].frame.id, 0x100u);
  EXPECT_EQ(bench.heard.frames[2].frame, frame(0x182, false));
}

TEST(FaultyBus, EachFaultOfTheVocabularyIsRefusedOrSetsAndClears) {
  const auto device = node("cia404-imu", 1);
  std::vector<std::string_view> taken;
  for (const auto& word : rig_config::fault_vocabulary()) {
    FaultConfig asked;
    asked.device = "imu";
    asked.kind = word.kind;
    asked.amount[0] = word.amount == "probability" ? 1 : word.usual;
    if (refusal(asked, device, FaultTarget::proxied)) continue;
    taken.push_back(word.name);

    Bench bench(device);
    std::vector<Heard::Frame> said;
    std::uint8_t counter = 0;
    const auto say_until = [&](Stamp end, Stamp from) {
      for (Stamp at = from; at < end; at += 100ms) {
        said.push_back({frame(0x181, false, counter++), at});
        bench.say(said.back().frame, at);
      }
      bench.run_until(end);
    };
    say_until(start + 1s, start);
    EXPECT_EQ(bench.heard.frames, said) << word.name << " before it was set";
    bench.schedule->set(asked, start + 1s);
    say_until(start + 3s, start + 1s);
    EXPECT_NE(bench.heard.frames, said) << word.name;
    EXPECT_GT(bench.bus.hits()[word.kind], 0u) << word.name;

    bench.schedule->clear(word.kind);
    bench.run_until(start + 5s);
    bench.heard = {};
    said.clear();
    say_until(start + 6s, start + 5s);
    EXPECT_EQ(bench.heard.frames, said) << word.name << " after it was cleared";
    EXPECT_TRUE(bench.bus.hears()) << word.name;
  }
  EXPECT_THAT(taken, ::testing::IsSupersetOf({"drop", "flip", "truncate", "duplicate", "reorder",
                                              "garbage", "hang", "bus-off", "error-frames", "delay",
                                              "jitter", "burst"}));
}

}  // namespace faulty_bus_test
