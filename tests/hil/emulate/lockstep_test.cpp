#include "hil/emulate/lockstep.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "drivers/wire/can/can_bits.hpp"
#include "drivers/wire/canopen/canopen.hpp"
#include "drivers/wire/nmea2000/fast_packet.hpp"
#include "hil/motion/kinematic_trajectory.hpp"
#include "tests/hil/emulate/bench.hpp"

namespace drydock::emulate {
namespace {

using rig_config::DeviceKind;

motion::KinematicTrajectory surfaced_turn() {
  rig_config::MissionConfig mission;
  mission.latitude_rad = 47 * degree;
  mission.speed_mps = 2;
  mission.legs = {{.kind = rig_config::LegKind::turn,
                   .duration_s = 60,
                   .turn_rad = 180 * degree,
                   .speed_mps = 2}};
  return {mission, start};
}

// All messages of one line in `seconds`, with their times.
std::vector<Recorder::Message> listen_to(const rig_config::DeviceConfig& config, unsigned baud,
                                         double seconds, std::uint64_t seed = 1) {
  const auto trajectory = surfaced_turn();
  std::vector<Recorder::Message> heard;
  EmulatedLine line(make_emulated_device(config, trajectory, seed).value(), baud,
                    [&](wire::Bytes bytes, const Passage& passage) {
                      heard.push_back({passage.ended_at, {bytes.begin(), bytes.end()}});
                    });
  shell::Lockstep lockstep(start);
  lockstep.add(line);
  lockstep.run_until(at_s(seconds));
  return heard;
}

TEST(EmulatedLine, SentencesArriveWhenTheirLastByteHasLeftTheLine) {
  const auto heard = listen_to(device(DeviceKind::emlog, "nmea0183"), 4800, 0.9);
  ASSERT_EQ(heard.size(), 3);
  std::size_t bytes = 0;
  for (const auto& message : heard) {
    bytes += message.bytes.size();
    EXPECT_NEAR(measurement::seconds(message.at - start), bytes * 10 / 4800.0, 2e-9 * heard.size());
  }
}

TEST(EmulatedLine, ALogThatSaysMoreThanItsLineCarriesLosesWholeSentences) {
  const auto trajectory = surfaced_turn();
  std::size_t damaged = 0;
  EmulatedLine line(
      make_emulated_device(device(DeviceKind::emlog, "nmea0183", 20), trajectory, 1).value(), 4800,
      [&](wire::Bytes bytes, const Passage&) {
        damaged += bytes.front() != '$' || bytes.back() != '\n';
      });
  shell::Lockstep lockstep(start);
  lockstep.add(line);
  lockstep.run_until(at_s(30));
  EXPECT_EQ(damaged, 0);
  EXPECT_GT(line.messages_lost(), 100);
}

TEST(EmulatedDevices, TheSameSeedSaysTheSameBytesAndAnotherSeedOthers) {
  auto config = device(DeviceKind::gnss, "ubx", 5);
  config.emulate.primary.noise = {1, 1, 2};
  const auto once = listen_to(config, 38400, 10);
  const auto again = listen_to(config, 38400, 10);
  const auto other = listen_to(config, 38400, 10, 2);
  ASSERT_EQ(once.size(), again.size());
  bool differs = false;
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].bytes, again[i].bytes);
    EXPECT_EQ(once[i].at, again[i].at);
    differs = differs || once[i].bytes != other.at(i).bytes;
  }
  EXPECT_TRUE(differs);
}

TEST(EmulatedDevices, AnUnknownCombinationIsRefusedWithWhatIsAllowed) {
  const auto trajectory = surfaced_turn();
  const auto made = make_emulated_device(device(DeviceKind::gnss, "pd0"), trajectory, 1);
  ASSERT_FALSE(made);
  EXPECT_EQ(
      made.error().message,
      "device \"pd0 device\": no emulated gnss speaks \"pd0\"; allowed: ubx, nmea0183, nmea2000");
}

struct HeardFrame {
  wire::CanFrame frame;
  Stamp at;
};

TEST(EmulatedBus, TwoNodesThatWantOneAddressSettleItByTheirNames) {
  const auto trajectory = surfaced_turn();
  std::vector<HeardFrame> heard;
  EmulatedBus bus(250'000, [&](const wire::CanFrame& frame, std::size_t, const Passage& passage) {
    heard.push_back({frame, passage.ended_at});
  });
  for (const char* name : {"one", "two"}) {
    auto config = device(DeviceKind::imu, "aceinna", 50);
    config.name = name;
    bus.add(make_emulated_device(config, trajectory, 1).value());
  }
  shell::Lockstep lockstep(start);
  lockstep.add(bus);
  lockstep.run_until(at_s(2));

  std::map<std::uint8_t, std::uint64_t> holder;  // the last claim of each address
  std::map<std::uint8_t, int> samples;
  std::set<std::uint64_t> names;
  for (const auto& [frame, at] : heard) {
    const auto source = static_cast<std::uint8_t>(frame.id);
    const std::uint32_t pgn = frame.id >> 8 & 0x3FFFF;
    if (pgn == 0xEEFF) {
      std::uint64_t name = 0;
      std::memcpy(&name, frame.data.data(), 8);
      holder[source] = name;
      names.insert(name);
    } else if (pgn == 61482 && at > at_s(1)) {
      ++samples[source];
    }
  }
  ASSERT_EQ(names.size(), 2);
  EXPECT_EQ(holder.at(0x80), *names.begin());  // the lower NAME keeps the address
  ASSERT_EQ(samples.size(), 2);                // each has an address to send from
  for (const auto& [address, count] : samples) EXPECT_NEAR(count, 50, 1) << int{address};
}

TEST(EmulatedBus, FramesOfAllNodesShareTheWireOneAfterTheOther) {
  const auto trajectory = surfaced_turn();
  std::vector<HeardFrame> heard;
  EmulatedBus bus(250'000, [&](const wire::CanFrame& frame, std::size_t, const Passage& passage) {
    heard.push_back({frame, passage.ended_at});
  });
  bus.add(make_emulated_device(device(DeviceKind::imu, "aceinna", 100), trajectory, 1).value());
  bus.add(make_emulated_device(device(DeviceKind::depth, "nmea2000", 100), trajectory, 1).value());
  bus.add(
      make_emulated_device(device(DeviceKind::actuator, "nmea2000", 50), trajectory, 1).value());
  shell::Lockstep lockstep(start);
  lockstep.add(bus);
  lockstep.run_until(at_s(5));
  ASSERT_GT(heard.size(), 2500);
  for (std::size_t i = 1; i < heard.size(); ++i) {
    const auto apart = heard[i].at - heard[i - 1].at;
    ASSERT_GE(apart.count(), 4000 * wire::classic_bits(heard[i].frame));
  }
}

TEST(EmulatedBus, ADriversFrameReachesTheNodesAfterItsTimeOnTheWire) {
  const auto trajectory = surfaced_turn();
  int samples = 0;
  EmulatedBus bus(250'000, [&](const wire::CanFrame& frame, std::size_t, const Passage&) {
    samples += frame.id == 0x181;
  });
  bus.add(make_emulated_device(device(DeviceKind::imu, "cia404-imu", 100), trajectory, 1).value());
  shell::Lockstep lockstep(start);
  lockstep.add(bus);
  lockstep.run_until(at_s(1));
  EXPECT_EQ(samples, 0);
  bus.receive(wire::canopen::encode(wire::canopen::Nmt{wire::canopen::NmtCommand::start, 1}),
              at_s(1));
  lockstep.run_until(at_s(2.005));
  EXPECT_EQ(samples, 100);
}

/// A group function that gives the heartbeat (126993) 1 s; the one of the log, 25h.
TEST(EmulatedBus, WhatANodeWasToldIsSaidOfThatNode) {
  const auto trajectory = surfaced_turn();
  EmulatedBus bus(250'000, [](const wire::CanFrame&, std::size_t, const Passage&) {});
  std::vector<std::string> told;
  bus.set_on_told([&](std::size_t sender, std::string_view what, Stamp) {
    told.push_back(std::to_string(sender) + ": " + std::string(what));
  });
  bus.add(make_emulated_device(device(DeviceKind::imu, "cia404-imu", 100), trajectory, 1).value());
  bus.add(make_emulated_device(device(DeviceKind::emlog, "nmea2000", 10), trajectory, 1).value());
  shell::Lockstep lockstep(start);
  lockstep.add(bus);
  lockstep.run_until(at_s(1));
  const std::array<std::uint8_t, 11> asked{0, 0x11, 0xF0, 0x01, 0xE8, 3, 0, 0, 0xFF, 0xFF, 0};
  for (std::size_t i = 0; i < wire::fast_packet_frames(asked.size()); ++i)
    bus.receive(wire::encode_fast_packet({3, 126208, 0x25, 100}, 0, asked, i), at_s(1));
  lockstep.run_until(at_s(1.1));
  EXPECT_EQ(told, std::vector<std::string>{"1: interval of PGN 126993: 1000 ms"});
}

}  // namespace
}  // namespace drydock::emulate
