// Drivers and emulated devices on a real SocketCAN interface, with can-utils at the other end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "drivers/shell/real_time.hpp"
#include "drivers/shell/rig_devices.hpp"
#include "hil/emulate/real_time/real_time.hpp"
#include "hil/motion/kinematic_trajectory.hpp"
#include "tests/drivers/link/running.hpp"
#include "tests/vcan/process.hpp"

namespace drydock::vcan {
namespace {

using namespace std::chrono_literals;
using namespace measurement;
using rig_config::DeviceKind;
using ::testing::HasSubstr;

rig_config::DeviceConfig device(DeviceKind kind, const std::string& protocol, double rate_hz) {
  rig_config::DeviceConfig config;
  config.name = protocol;
  config.kind = kind;
  config.protocol = protocol;
  config.link = "socketcan:" + interface();
  config.rate_hz = rate_hz;
  return config;
}

class Bench : public ::testing::Test, public device::Listener {
 protected:
  void start_drivers(const std::vector<rig_config::DeviceConfig>& configs) {
    rig_.devices = configs;
    auto devices = shell::make_devices(rig_);
    ASSERT_TRUE(devices) << devices.error().message;
    drivers_ = std::make_unique<shell::RealTime>(io, std::move(*devices), *this);
    drivers_->start();
  }

  /// Runs until `count` measurements of the kind have come, at most five seconds.
  template <class Kind>
  std::vector<Kind> take(std::size_t count) {
    std::vector<Kind> taken;
    link::testing::run_until(io, [&] {
      taken.clear();
      for (const auto& m : measurements)
        if (const auto* one = std::get_if<Kind>(&m)) taken.push_back(*one);
      return taken.size() >= count;
    });
    return taken;
  }

  void TearDown() override {
    if (!drivers_) return;
    for (std::size_t i = 0; i < drivers_->size(); ++i) {
      const auto health = drivers_->health(i);
      EXPECT_EQ(health.stream.bad_checksums, 0u) << drivers_->device(i).name();
      EXPECT_EQ(health.stream.bytes_in,
                health.stream.bytes_good + health.stream.bytes_skipped + health.held_bytes);
      EXPECT_EQ(health.can_dropped, 0u);
    }
    drivers_->stop();
    link::testing::settle(io);
  }

  link::asio::io_context io;
  std::vector<Measurement> measurements;

 private:
  void on_measurement(const Measurement& m) override { measurements.push_back(m); }
  void on_state(const device::Device&, const device::Transition&) override {}

  rig_config::Rig rig_;
  std::unique_ptr<shell::RealTime> drivers_;
};

TEST_F(Bench, CandumpSeesTheEmulatedDevicesAndTheDriversGetTheTruth) {
  auto imu = device(DeviceKind::imu, "cia404-imu", 100);
  imu.address = 1;
  const auto depth = device(DeviceKind::depth, "nmea2000", 10);
  rig_config::MissionConfig mission;
  mission.depth_m = 20;
  mission.latitude_rad = 0.6;
  mission.legs = {{.kind = rig_config::LegKind::straight, .duration_s = 60}};
  const motion::KinematicTrajectory trajectory(mission, link::now());
  emulate::SoundDevices sound(trajectory, 1);
  emulate::RealTimeEmulator emulator(io, sound);
  const int before = receiver_count(interface());
  Process candump({"candump", "-L", interface()});
  ASSERT_TRUE(wait_for_receivers(interface(), before + 1));

  start_drivers({imu, depth});
  ASSERT_TRUE(emulator.start({imu, depth}));
  const auto samples = take<ImuSample>(50);
  const auto depths = take<DepthSample>(5);
  emulator.stop();

  ASSERT_GE(samples.size(), 50u);
  // At rest at latitude 0.6 rad, 20 m down: Somigliana gravity 9.7968 m/s2.
  EXPECT_NEAR(samples.back().specific_force.z(), -9.7968, 0.001);
  EXPECT_NEAR(samples.back().angular_rate.norm(), 7.2921e-5, 1e-6);
  // Echo sounder messages contain only the height over the bed; pressure messages contain the
  // depth.
  const auto depth_of = std::find_if(depths.begin(), depths.end(),
                                     [](const DepthSample& d) { return d.depth_m.has_value(); });
  ASSERT_NE(depth_of, depths.end());
  EXPECT_NEAR(*depth_of->depth_m, 20, 0.05);
  const auto seen = candump.output_until("15FD0A", 5);
  EXPECT_THAT(seen, HasSubstr(" 000#01"));  // the driver starts the CANopen node
  EXPECT_THAT(seen, HasSubstr(" 181#"));
  EXPECT_THAT(seen, HasSubstr(" 281#"));
  EXPECT_THAT(seen, HasSubstr("15FD0A"));  // PGN 130314, priority 5
}

TEST_F(Bench, TheDriverReadsWhatCanplayerPlaysBackFromARealSensor) {
  start_drivers({device(DeviceKind::imu, "aceinna", 100)});
  link::testing::settle(io);
  ASSERT_EQ(run_program({"canplayer", "-t", "-I", DRYDOCK_SOURCE_DIR "/fixtures/aceinna/frames.log",
                         interface() + "=can0"}),
            0);
  const auto samples = take<ImuSample>(1);
  // The vendor's own script decodes these frames to the same values (fixtures/aceinna/NOTE.md).
  ASSERT_EQ(samples.size(), 1u);
  EXPECT_NEAR(samples[0].specific_force.norm(), std::sqrt(9.75 * 9.75 + 0.85 * 0.85 + 0.01), 1e-9);
  EXPECT_NEAR(samples[0].angular_rate.x() * 180 / M_PI, 9.5703125, 1e-9);
  EXPECT_EQ(samples[0].origin.provenance, Provenance::emulated);
}

TEST_F(Bench, ASingleFrameFromCansendIsADepth) {
  start_drivers({device(DeviceKind::depth, "nmea2000", 1)});
  link::testing::settle(io);
  // 130314: SID 0, instance 0, source 1 (water), 2 013 250 steps of 0.1 Pa.
  ASSERT_EQ(run_program({"cansend", interface(), "15FD0A20#00000142B81E00FF"}), 0);
  const auto depths = take<DepthSample>(1);
  ASSERT_EQ(depths.size(), 1u);
  EXPECT_NEAR(*depths[0].pressure_pa, 201325.0, 0.1);
  EXPECT_NEAR(*depths[0].depth_m, (201325.0 - 101325.0) / (1025 * 9.80665), 1e-4);
}

}  // namespace
}  // namespace drydock::vcan
