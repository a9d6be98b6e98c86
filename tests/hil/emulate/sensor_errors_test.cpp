#include <gtest/gtest.h>

#include <algorithm>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/canopen/canopen.hpp"
#include "drivers/wire/dvl/pd0.hpp"
#include "hil/sensor/ideal.hpp"
#include "hil/sensor/imu_errors.hpp"
#include "rig_config/load.hpp"
#include "tests/hil/emulate/bench.hpp"

/// The error models of docs/sensors/errors.md, seen on the wire.
namespace drydock::emulate {
namespace sensor_errors_test {

using rig_config::DeviceKind;

const std::string sensors = DRYDOCK_SOURCE_DIR "/rig_config/sensors/";

Recorder record_started(const rig_config::DeviceConfig& config, const motion::Trajectory& truth,
                        double seconds) {
  namespace canopen = wire::canopen;
  const auto made = make_emulated_device(config, truth, 1).value();
  Recorder sent;
  sent.run(*made, start);  // boots
  made->receive(canopen::encode(canopen::Nmt{canopen::NmtCommand::start, 1}), start, sent);
  sent.run(*made, at_s(seconds));
  return sent;
}

TEST(SensorErrors, AGradeNamedInARigReachesTheWire) {
  const auto rig = rig_config::load_rig_text(
                       "[rig]\nname = \"r\"\n[[device]]\nname = \"imu\"\nkind = \"imu\"\n"
                       "protocol = \"cia404-imu\"\nlink = \"can:auto\"\naddress = 1\n"
                       "emulate = { errors = \"mixing-paper.toml\" }\n",
                       sensors + "r.toml")
                       .value();
  const auto& config = rig.devices.at(0);
  EXPECT_EQ(config.rate_hz, 100);  // from the grade
  const Frozen trajectory(under_way());
  const auto sent = record_started(config, trajectory, 0.1);

  sensor::ImuErrors errors(config.emulate, 100, 1, "imu");
  int samples = 0;
  for (const auto& [at, frame] : sent.frames) {
    if (frame.id != 0x181) continue;
    const auto expected = errors.apply(sensor::ideal_imu(trajectory, at, {}));
    EXPECT_EQ(wire::load_le<float>(frame.payload(), 0),
              static_cast<float>(expected.angular_rate.x()));
    EXPECT_EQ(wire::load_le<float>(frame.payload(), 4),
              static_cast<float>(expected.angular_rate.y()));
    ++samples;
  }
  EXPECT_EQ(samples, 10);
}

TEST(SensorErrors, ADvlsScaleFactorAndStepAreInItsEnsembles) {
  const Frozen trajectory(under_way());  // 2 m/s ahead
  auto config = device(DeviceKind::dvl, "pd0", 5);
  config.emulate.primary.scale_factor = {10e-3, 0, 0};
  config.emulate.primary.quantisation = {0.05, 0, 0};
  const auto sent = record(config, trajectory, 1);
  for (const auto& message : sent.messages) {
    const auto ensemble = wire::Pd0::decode(message.bytes);
    ASSERT_TRUE(ensemble);
    const auto& track = std::get<wire::Pd0Ensemble>(*ensemble).bottom_track;
    EXPECT_DOUBLE_EQ(*track->velocity_mps[1], 2.0);  // 2.02, in steps of 0.05
  }
}

TEST(Dropouts, WhatArrivesIsWhatWouldHaveArrived) {
  const Frozen trajectory(at_the_surface());
  for (const auto& [kind, protocol] : {std::pair{DeviceKind::dvl, "pd0"},
                                       {DeviceKind::dvl, "pd6"},
                                       {DeviceKind::dvl, "water-linked"},
                                       {DeviceKind::emlog, "nmea0183"},
                                       {DeviceKind::gnss, "ubx"},
                                       {DeviceKind::gnss, "nmea0183"}}) {
    auto config = device(kind, protocol, 10);
    config.emulate.primary.noise = {0.1, 0.1, 0.1};
    config.emulate.latency_s = 0.02;
    const auto all = record(config, trajectory, 100);
    config.emulate.dropout = {0.1, 3};
    const auto some = record(config, trajectory, 100);
    // Three of thirteen are lost: p L / (1 + p L). Their number varies because they come in bursts.
    const double share =
        static_cast<double>(some.messages.size()) / static_cast<double>(all.messages.size());
    EXPECT_NEAR(share, 1 / 1.3, 0.06) << protocol;
    auto next = all.messages.begin();
    for (const auto& message : some.messages) {
      next = std::find_if(next, all.messages.end(), [&](const auto& m) {
        return m.at == message.at && m.bytes == message.bytes;
      });
      ASSERT_NE(next, all.messages.end()) << protocol;
      ++next;
    }
  }
}

TEST(Dropouts, OfABusNodeLoseSamplesNotHeartbeats) {
  const Frozen trajectory(under_way());
  auto config = device(DeviceKind::imu, "epson-g552", 100);
  config.emulate.dropout = {0.2, 5};
  const auto sent = record_started(config, trajectory, 20);
  const auto count = [&](std::uint32_t id) {
    return std::ranges::count_if(sent.frames, [&](const auto& f) { return f.frame.id == id; });
  };
  EXPECT_EQ(count(0x701), 21);                                // boot-up, then one a second
  EXPECT_EQ(count(0x181), count(0x381));                      // only whole samples
  EXPECT_NEAR(static_cast<double>(count(0x181)), 1000, 120);  // every second sample
  std::uint16_t counter = 0;
  for (const auto& [at, frame] : sent.frames) {
    if (frame.id != 0x181) continue;
    const auto now = wire::load_le<std::uint16_t>(frame.payload(), 0);
    EXPECT_EQ(now, (at - start) / std::chrono::milliseconds{10} - 1);  // a gap is visible
    counter = now;
  }
  EXPECT_GT(counter, 1900);
}

TEST(Dropouts, CountForSamplesTakenOnSyncToo) {
  namespace canopen = wire::canopen;
  const Frozen trajectory(under_way());
  auto config = device(DeviceKind::imu, "cia404-imu", 100);
  config.sync = true;
  config.emulate.dropout = {1, 1};  // every second sample: an outage of one sample, then the next
                                    // outage begins
  const auto made = make_emulated_device(config, trajectory, 1).value();
  Recorder sent;
  sent.run(*made, start);
  made->receive(canopen::encode(canopen::Nmt{canopen::NmtCommand::start, 1}), start, sent);
  for (int k = 1; k <= 10; ++k) {
    made->receive(canopen::sync_frame(), at_s(k * 0.01), sent);
    sent.run(*made, at_s(k * 0.01));
  }
  EXPECT_EQ(std::ranges::count_if(sent.frames, [](const auto& f) { return f.frame.id == 0x181; }),
            5);
}

}  // namespace sensor_errors_test
}  // namespace drydock::emulate
