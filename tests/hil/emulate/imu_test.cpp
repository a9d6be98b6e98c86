#include <gtest/gtest.h>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/canopen/cia404_imu.hpp"
#include "drivers/wire/j1939/aceinna.hpp"
#include "tests/hil/emulate/bench.hpp"

namespace drydock::emulate {
namespace {

using rig_config::DeviceKind;
using wire::load_le;
namespace canopen = wire::canopen;

std::vector<Recorder::Frame> with_id(const Recorder& sent, std::uint32_t id) {
  std::vector<Recorder::Frame> found;
  for (const auto& f : sent.frames) {
    if (f.frame.id == id) found.push_back(f);
  }
  return found;
}

TEST(EmulatedAceinnaImu, ClaimsItsAddressBeforeItSaysAnythingElse) {
  const Frozen trajectory(under_way());
  const auto sent = record(device(DeviceKind::imu, "aceinna", 100), trajectory, 1);
  EXPECT_EQ(sent.frames.at(0).frame.id, 0x18EEFF80);
  EXPECT_EQ(sent.frames.at(0).at, start);
  // J1939-81: after 250 ms without a contending claim the address is its own.
  EXPECT_GE(sent.frames.at(1).at, at_s(0.25));
  EXPECT_LE(sent.frames.at(1).at, at_s(0.26));
}

// Scales of the vendor's DBC 19.1.51: rates 1/128 deg/s from -250, accelerations 0.01 m/s2 from
// -320, angles 1/32768 deg from -250.
TEST(EmulatedAceinnaImu, FramesHoldTheTruthInTheVendorsUnits) {
  const Frozen trajectory(under_way());
  const auto sent = record(device(DeviceKind::imu, "aceinna", 100), trajectory, 1);
  const auto ari = with_id(sent, 0x0CF02A80).at(0).frame;
  const auto accs = with_id(sent, 0x08F02D80).at(0).frame;
  const auto ssi2 = with_id(sent, 0x0CF02980).at(0).frame;
  const Eigen::Vector3d f(0.7, -0.5, -9.78), w(0.01, -0.02, 0.03);
  for (int axis = 0; axis < 3; ++axis) {
    const auto offset = static_cast<std::size_t>(2 * axis);
    const double rate = load_le<std::uint16_t>(ari.payload(), offset) / 128.0 - 250;
    EXPECT_NEAR(rate * degree, w[axis], 0.5 / 128 * degree + 1e-9);
    const double force = load_le<std::uint16_t>(accs.payload(), offset) * 0.01 - 320;
    EXPECT_NEAR(force, f[axis], 0.005 + 1e-9);
  }
  const auto angle = [&](std::size_t offset) {
    const std::uint32_t raw = ssi2.data[offset] | ssi2.data[offset + 1] << 8 |
                              static_cast<std::uint32_t>(ssi2.data[offset + 2]) << 16;
    return raw / 32768.0 - 250;
  };
  EXPECT_NEAR(angle(0), -4, 1e-4);
  EXPECT_NEAR(angle(3), 3, 1e-4);
}

TEST(EmulatedAceinnaImu, KeepsItsRateToTheNanosecond) {
  const Frozen trajectory(under_way());
  const auto sent = record(device(DeviceKind::imu, "aceinna", 100), trajectory, 3600);
  const auto ari = with_id(sent, 0x0CF02A80);
  EXPECT_EQ(ari.back().at, at_s(3600));
  for (std::size_t i = 1; i < ari.size(); ++i) {
    ASSERT_EQ(ari[i].at - ari[i - 1].at, std::chrono::milliseconds{10});
  }
}

TEST(EmulatedImu, WhatIsSampledIsSentLaterByTheLatency) {
  const Frozen trajectory(under_way());
  auto config = device(DeviceKind::imu, "aceinna", 100);
  config.emulate.latency_s = 0.003;
  const auto ari = with_id(record(config, trajectory, 1), 0x0CF02A80).at(0);
  EXPECT_EQ((ari.at - start) % std::chrono::milliseconds{10}, std::chrono::milliseconds{3});
  // Byte 7 is the age in half milliseconds: 3 ms, plus two earlier frames of 0.54 ms.
  EXPECT_NEAR(ari.frame.data[7] * 0.5e-3, 0.003 + 2 * 0.54e-3, 0.25e-3 + 1e-9);
}

TEST(EmulatedCia404Imu, BootsWaitsToBeStartedAndThenSends) {
  const Frozen trajectory(under_way());
  auto config = device(DeviceKind::imu, "cia404-imu", 100);
  config.address = 5;
  const auto imu = make_emulated_device(config, trajectory, 1).value();
  Recorder sent;
  sent.run(*imu, at_s(2.5));
  ASSERT_EQ(sent.frames.size(), 3);  // boot-up at once, then a heartbeat each second
  EXPECT_EQ(sent.frames[0].frame.id, 0x705u);
  EXPECT_EQ(sent.frames[0].frame.data[0], 0x00);
  EXPECT_EQ(sent.frames[1].frame.data[0], 0x7F);
  EXPECT_EQ(sent.frames[2].at, at_s(2));

  imu->receive(canopen::encode(canopen::Nmt{canopen::NmtCommand::start, 6}), sent.now, sent);
  sent.run(*imu, at_s(2.7));
  EXPECT_EQ(sent.frames.size(), 3);  // that was for another node

  imu->receive(canopen::encode(canopen::Nmt{canopen::NmtCommand::start, 0}), sent.now, sent);
  sent.run(*imu, at_s(2.8));
  EXPECT_EQ(with_id(sent, 0x185).size(), 10);
  EXPECT_EQ(with_id(sent, 0x385).size(), 10);

  imu->receive(canopen::encode(canopen::Nmt{canopen::NmtCommand::reset_node, 5}), sent.now, sent);
  EXPECT_EQ(sent.frames.back().frame.id, 0x705u);
  EXPECT_EQ(sent.frames.back().frame.data[0], 0x00);
  const auto before = sent.frames.size();
  sent.run(*imu, at_s(3.5));
  EXPECT_EQ(sent.frames.size(), before);
}

TEST(EmulatedCia404Imu, ThreeProcessDataObjectsHoldTheSixValuesAsReal32) {
  const Frozen trajectory(under_way());
  const auto imu =
      make_emulated_device(device(DeviceKind::imu, "cia404-imu", 100), trajectory, 1).value();
  Recorder sent;
  sent.run(*imu, start);  // boots
  imu->receive(canopen::encode(canopen::Nmt{canopen::NmtCommand::start, 1}), start, sent);
  sent.run(*imu, at_s(0.01));
  ASSERT_EQ(sent.frames.size(), 4);
  const std::array<float, 6> expected{0.01f, -0.02f, 0.03f, 0.7f, -0.5f, -9.78f};
  for (std::size_t i = 0; i < 6; ++i) {
    const auto& frame = sent.frames[1 + i / 2].frame;
    EXPECT_EQ(frame.id, 0x181u + 0x100 * (i / 2));
    EXPECT_FLOAT_EQ(load_le<float>(frame.payload(), 4 * (i % 2)), expected[i]);
  }
}

/// An emulated Aceinna IMU with address 80h.
struct HeldAceinna {
  HeldAceinna() { sent.run(*imu, at_s(0.5)); }
  /// Its frames in the second after it received `frame`.
  Recorder after(const wire::CanFrame& frame) {
    sent.frames.clear();
    imu->receive(frame, sent.now, sent);
    sent.run(*imu, sent.now + std::chrono::seconds{1});
    return sent;
  }
  Frozen trajectory{under_way()};
  std::unique_ptr<EmulatedDevice> imu =
      make_emulated_device(device(DeviceKind::imu, "aceinna", 100), trajectory, 1).value();
  Recorder sent;
};

constexpr std::uint32_t ssi2_id = 0x0CF02980, ari_id = 0x0CF02A80, accs_id = 0x08F02D80;

TEST(EmulatedAceinnaImu, ObeysPacketRateAndTypeSentToItsAddress) {
  using namespace wire::aceinna;
  HeldAceinna bench;
  EXPECT_EQ(with_id(bench.after(encode(PacketRate{0, 0x81, 10})), ari_id).size(), 100);
  EXPECT_EQ(with_id(bench.after(encode(PacketRate{0, 0x80, 3})), ari_id).size(),
            100);  // 3 is not a valid divider
  EXPECT_EQ(with_id(bench.after(encode(PacketRate{0, 0x80, 10})), ari_id).size(), 10);
  const auto without_slope = bench.after(encode(PacketType{0, 0x80, 6}));
  EXPECT_EQ(with_id(without_slope, ssi2_id).size(), 0);
  EXPECT_EQ(with_id(without_slope, accs_id).size(), 10);
  EXPECT_TRUE(bench.after(encode(PacketRate{0, 0x80, 0})).frames.empty());  // quiet
}

TEST(EmulatedAceinnaImu, AnswersARequestWithTheSettingInForce) {
  using namespace wire::aceinna;
  HeldAceinna bench;
  bench.after(encode(DigitalFilter{0, 0x80, 10, 5}));
  const auto sent = bench.after(wire::j1939::encode(wire::j1939::Request{0, 0x80, filter_pgn}));
  const auto answer = with_id(sent, 0x18FF5780);
  ASSERT_EQ(answer.size(), 1);
  EXPECT_EQ(answer[0].frame, encode(DigitalFilter{0x80, 0x80, 10, 5}));
  const auto status = bench.after(wire::j1939::encode(wire::j1939::Request{0, 0xFF, status_pgn}));
  EXPECT_EQ(with_id(status, 0x18FF5480).size(), 1);
  EXPECT_TRUE(with_id(bench.after(wire::j1939::encode(wire::j1939::Request{0, 0x81, status_pgn})),
                      0x18FF5480)
                  .empty());
}

TEST(EmulatedAceinnaImu, OrientationTurnsItsOutput) {
  HeldAceinna bench;
  const auto axes = wire::aceinna::Axes::of_text("-Y+X+Z");
  const auto turned = bench.after(encode(wire::aceinna::Orientation{0, 0x80, axes->code()}));
  const auto accs = with_id(turned, accs_id).at(0).frame;
  // The output's x is the housing's -y, and its y is the housing's x.
  EXPECT_NEAR(load_le<std::uint16_t>(accs.payload(), 0) * 0.01 - 320, 0.5, 0.005 + 1e-9);
  EXPECT_NEAR(load_le<std::uint16_t>(accs.payload(), 2) * 0.01 - 320, 0.7, 0.005 + 1e-9);
}

TEST(EmulatedMv5Imu, SendsTheLateralAxisFirst) {
  const Frozen trajectory(under_way());
  const auto sent = record(device(DeviceKind::imu, "microstrain-mv5", 100), trajectory, 1);
  EXPECT_EQ(sent.frames.at(0).frame.id, 0x18EEFFE2);
  const auto force = with_id(sent, 0x08F02DE2).at(0).frame;
  const auto rate = with_id(sent, 0x0CF02AE2).at(0).frame;
  const std::array<double, 3> f{-0.5, 0.7, -9.78}, w{-0.02, 0.01, 0.03};  // Y, X, Z
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(load_le<std::uint16_t>(force.payload(), 2 * i) * 0.01 - 320, f[i], 0.005 + 1e-9);
    const double degps = load_le<std::uint16_t>(rate.payload(), 2 * i) / 128.0 - 250;
    EXPECT_NEAR(degps * degree, w[i], 0.5 / 128 * degree + 1e-9);
  }
  EXPECT_EQ(with_id(sent, 0x0CF029E2).size(), with_id(sent, 0x0CF02AE2).size());
}

TEST(EmulatedSbgImu, PutsTheTimeBeforeTheTwoVectors) {
  const Frozen trajectory(under_way());
  const auto sent = record(device(DeviceKind::imu, "sbg", 100), trajectory, 0.02);
  ASSERT_EQ(sent.frames.size(), 9);
  EXPECT_EQ(sent.frames[6].frame.id, 0x120);
  EXPECT_EQ(load_le<std::uint32_t>(sent.frames[6].frame.payload(), 0), 20'000);  // us
  const auto force = with_id(sent, 0x121)[0].frame, rate = with_id(sent, 0x122)[0].frame;
  EXPECT_EQ(load_le<std::int16_t>(force.payload(), 4), -978);  // -9.78 m/s2
  EXPECT_EQ(load_le<std::int16_t>(rate.payload(), 4), 30);     // 0.03 rad/s
}

TEST(EmulatedXsensImu, MarksEachGroupWithTicksAndCounterOnTheIdentifiersOfTheRig) {
  const Frozen trajectory(under_way());
  auto config = device(DeviceKind::imu, "xsens", 100);
  config.xsens.identifiers = {{"sample_time", 0x105}};
  const auto sent = record(config, trajectory, 0.02);
  ASSERT_EQ(sent.frames.size(), 15);
  EXPECT_TRUE(with_id(sent, 0x005).empty());
  const auto times = with_id(sent, 0x105);
  ASSERT_EQ(times.size(), 3);
  EXPECT_EQ(times[2].frame.data[3], 200);  // 20 ms in ticks of 100 us, big-endian
  EXPECT_EQ(with_id(sent, 0x006)[1].frame.data[1], 1);
  // 2^-9 rad/s and 2^-8 m/s2.
  const auto rate = with_id(sent, 0x032)[0].frame, force = with_id(sent, 0x034)[0].frame;
  EXPECT_EQ(wire::load_be<std::int16_t>(rate.payload(), 4), 15);      // 0.03 * 512
  EXPECT_EQ(wire::load_be<std::int16_t>(force.payload(), 4), -2504);  // -9.78 * 256
}

TEST(EmulatedEpsonImu, SendsIntegersOfOneCounterAndAnEmergencyWhenTheyOverflow) {
  auto truth = under_way();
  const Frozen trajectory(truth);
  auto config = device(DeviceKind::imu, "epson-g552", 100);
  const auto imu = make_emulated_device(config, trajectory, 1).value();
  Recorder sent;
  sent.run(*imu, start);
  imu->receive(canopen::encode(canopen::Nmt{canopen::NmtCommand::start, 1}), start, sent);
  sent.run(*imu, at_s(0.01));
  const auto gyro = with_id(sent, 0x181).at(0).frame, force = with_id(sent, 0x281).at(0).frame;
  EXPECT_EQ(load_le<std::uint16_t>(gyro.payload(), 0), load_le<std::uint16_t>(force.payload(), 0));
  EXPECT_EQ(load_le<std::int16_t>(gyro.payload(), 2), 38);      // 0.01 rad/s / 0.01515 deg/s
  EXPECT_EQ(load_le<std::int16_t>(force.payload(), 6), -2493);  // -9.78 m/s2 / 0.4 mg
  EXPECT_TRUE(with_id(sent, 0x081).empty());

  truth.specific_force.x() = 200;  // 20 g; the range of the integers ends at 13.1 g
  const Frozen shaken(truth);
  const auto other = make_emulated_device(config, shaken, 1).value();
  Recorder loud;
  loud.run(*other, start);
  other->receive(canopen::encode(canopen::Nmt{canopen::NmtCommand::start, 1}), start, loud);
  loud.run(*other, at_s(0.05));
  ASSERT_EQ(with_id(loud, 0x081).size(), 1);  // only once
  EXPECT_EQ(load_le<std::uint16_t>(with_id(loud, 0x081)[0].frame.payload(), 0), 0xFF00);
}

TEST(EmulatedImu, BiasIsAddedInTheSensorsAxes) {
  const Frozen trajectory(under_way());
  auto config = device(DeviceKind::imu, "cia404-imu", 100);
  config.mounting_rad = {0, 0, 90 * degree};
  config.emulate.primary.bias = {0.001, 0, 0};
  const auto imu = make_emulated_device(config, trajectory, 1).value();
  Recorder sent;
  sent.run(*imu, start);  // boots
  imu->receive(canopen::encode(canopen::Nmt{canopen::NmtCommand::start, 1}), start, sent);
  sent.run(*imu, at_s(0.01));
  // The sensor's x is the vehicle's y, and its y is the vehicle's -x.
  EXPECT_FLOAT_EQ(load_le<float>(sent.frames.at(1).frame.payload(), 0), -0.02f + 0.001f);
  EXPECT_FLOAT_EQ(load_le<float>(sent.frames.at(1).frame.payload(), 4), -0.01f);
}

}  // namespace
}  // namespace drydock::emulate
