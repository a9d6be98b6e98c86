#include <gtest/gtest.h>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/cia404_imu.hpp"
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
  // J1939-81: 250 ms without contradiction make the address its own.
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
  // Byte 7 is the age in half milliseconds: 3 ms and two frames of 0.54 ms before it.
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
  imu->receive(canopen::encode(canopen::Nmt{canopen::NmtCommand::start, 1}), start, sent);
  sent.run(*imu, at_s(0.005));
  ASSERT_EQ(sent.frames.size(), 4);
  const std::array<float, 6> expected{0.01f, -0.02f, 0.03f, 0.7f, -0.5f, -9.78f};
  for (std::size_t i = 0; i < 6; ++i) {
    const auto& frame = sent.frames[1 + i / 2].frame;
    EXPECT_EQ(frame.id, 0x181u + 0x100 * (i / 2));
    EXPECT_FLOAT_EQ(load_le<float>(frame.payload(), 4 * (i % 2)), expected[i]);
  }
}

TEST(EmulatedImu, BiasIsAddedInTheSensorsAxes) {
  const Frozen trajectory(under_way());
  auto config = device(DeviceKind::imu, "cia404-imu", 100);
  config.mounting_rad = {0, 0, 90 * degree};
  config.emulate.primary.bias = {0.001, 0, 0};
  const auto imu = make_emulated_device(config, trajectory, 1).value();
  Recorder sent;
  imu->receive(canopen::encode(canopen::Nmt{canopen::NmtCommand::start, 1}), start, sent);
  sent.run(*imu, start);
  // The sensor's x is the vehicle's y, its y the vehicle's -x.
  EXPECT_FLOAT_EQ(load_le<float>(sent.frames.at(1).frame.payload(), 0), -0.02f + 0.001f);
  EXPECT_FLOAT_EQ(load_le<float>(sent.frames.at(1).frame.payload(), 4), -0.01f);
}

}  // namespace
}  // namespace drydock::emulate
