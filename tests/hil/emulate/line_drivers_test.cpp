// The output of serial drivers for emulated devices: velocity, speed, position.
#include <gtest/gtest.h>

#include <cmath>

#include "estimators/frame/attitude.hpp"
#include "tests/hil/emulate/through_drivers.hpp"

namespace drydock::emulate {
namespace line_drivers_test {

using Eigen::Vector3d;
using rig_config::DeviceKind;

TEST_F(ThroughDrivers, TheDvlsVelocityAndAltitude) {
  auto config = device(DeviceKind::dvl, "pd0", 5);
  run_line(device::Kind::dvl, config, 115200);
  const auto samples = all<measurement::BottomVelocity>();
  EXPECT_EQ(samples.size(), 450);
  for (const auto& sample : samples) {
    const auto truth = trajectory_.at(sample.origin.valid_at);
    ASSERT_TRUE(sample.velocity && sample.altitude_m);
    EXPECT_LT((*sample.velocity - truth.velocity_body).norm(), 1.5e-3);
    EXPECT_NEAR(*sample.altitude_m, truth.bed_depth_m + truth.height_m, 0.02);
  }
}

TEST_F(ThroughDrivers, Pd4Pd5AndPd6OfBothMakers) {
  using enum rig_config::DvlMaker;
  for (const auto& [protocol, maker] : {std::pair{"pd4", teledyne},
                                        {"pd4", water_linked},
                                        {"pd5", teledyne},
                                        {"pd6", teledyne},
                                        {"pd6", water_linked}}) {
    measurements_.clear();
    auto config = device(DeviceKind::dvl, protocol, 5);
    config.maker = maker;
    config.mounting_rad = {0, 0, 45 * degree};
    run_line(device::Kind::dvl, config, 115200);
    const auto samples = all<measurement::BottomVelocity>();
    EXPECT_EQ(samples.size(), 450) << protocol;
    for (const auto& sample : samples) {
      const auto truth = trajectory_.at(sample.origin.valid_at);
      ASSERT_TRUE(sample.velocity);
      EXPECT_LT((*sample.velocity - truth.velocity_body).norm(), 1.5e-3);
      EXPECT_EQ(sample.altitude_m.has_value(), std::string_view{protocol} != "pd4");
      if (!sample.altitude_m) continue;
      EXPECT_NEAR(*sample.altitude_m, truth.bed_depth_m + truth.height_m, 0.02);
    }
  }
}

TEST_F(ThroughDrivers, WaterLinkedAndNortekDvlsKnowTheirOwnLatency) {
  for (const char* protocol : {"water-linked", "water-linked-json", "nortek"}) {
    measurements_.clear();
    auto config = device(DeviceKind::dvl, protocol, 5);
    config.emulate.latency_s = 0.075;  // the driver does not know this latency
    run_line(device::Kind::dvl, config, 115200);
    int locked = 0;
    const auto samples = all<measurement::BottomVelocity>();
    EXPECT_EQ(samples.size(), 450);
    for (const auto& sample : samples) {
      const auto truth = trajectory_.at(sample.origin.valid_at);
      if (!sample.velocity) continue;  // the bed is out of range
      ++locked;
      EXPECT_LT((*sample.velocity - truth.velocity_body).norm(), 1.5e-3);
      if (sample.altitude_m) {
        EXPECT_NEAR(*sample.altitude_m, truth.bed_depth_m + truth.height_m, 0.02);
      }
      EXPECT_LT(std::abs(measurement::seconds((sample.origin.valid_at - start) %
                                              std::chrono::milliseconds{200})),
                1e-6);
    }
    EXPECT_GT(locked, 50) << protocol;
  }
}

TEST_F(ThroughDrivers, AWayfinderOfEitherSign) {
  for (const bool of_bed : {false, true}) {
    measurements_.clear();
    auto config = device(DeviceKind::dvl, "wayfinder", 5);
    config.mounting_rad = {0, 0, 45 * degree};
    config.velocity_of_bed = of_bed;
    run_line(device::Kind::dvl, config, 115200);
    const auto samples = all<measurement::BottomVelocity>();
    EXPECT_EQ(samples.size(), 450);
    int locked = 0;
    for (const auto& sample : samples) {
      if (!sample.velocity) continue;  // the bed is out of range
      ++locked;
      const auto truth = trajectory_.at(sample.origin.valid_at);
      EXPECT_LT((*sample.velocity - truth.velocity_body).norm(), 1e-6);
    }
    EXPECT_GT(locked, 50);
  }
}

TEST_F(ThroughDrivers, ABinaryRecordOfNortekTellsItsAgeAndTheAltitudeOfALevelDvl) {
  auto config = device(DeviceKind::dvl, "nortek-ad2cp", 5);
  config.emulate.latency_s = 0.075;  // the driver does not know this latency
  config.mounting_rad = {0, 0, 30 * degree};
  run_line(device::Kind::dvl, config, 115200);
  const auto samples = all<measurement::BottomVelocity>();
  EXPECT_EQ(samples.size(), 450);
  int locked = 0;
  for (const auto& sample : samples) {
    const auto truth = trajectory_.at(sample.origin.valid_at);
    if (!sample.velocity) continue;  // the bed is out of range
    ++locked;
    EXPECT_LT((*sample.velocity - truth.velocity_body).norm(), 1e-5);
    ASSERT_TRUE(sample.altitude_m);
    EXPECT_NEAR(*sample.altitude_m * std::cos(truth.pitch_rad) * std::cos(truth.roll_rad),
                truth.bed_depth_m + truth.height_m, 0.02);
    EXPECT_LT(std::abs(std::remainder(measurement::seconds(sample.origin.valid_at - start), 0.2)),
              1e-6);
    // The clock has steps of 100 us.
    EXPECT_NEAR(measurement::seconds(*sample.origin.device_time -
                                     sample.origin.valid_at.time_since_epoch()),
                -50e-6, 51e-6);
  }
  EXPECT_GT(locked, 50);
}

TEST_F(ThroughDrivers, ASignatureOfEitherSign) {
  for (const bool of_bed : {false, true}) {
    measurements_.clear();
    auto config = device(DeviceKind::dvl, "nortek-ad2cp", 5);
    config.mounting_rad = {0, 0, 30 * degree};
    config.velocity_of_bed = of_bed;
    run_line(device::Kind::dvl, config, 115200);
    const auto samples = all<measurement::BottomVelocity>();
    EXPECT_EQ(samples.size(), 450);
    int locked = 0;
    for (const auto& sample : samples) {
      if (!sample.velocity) continue;  // the bed is out of range
      ++locked;
      const auto truth = trajectory_.at(sample.origin.valid_at);
      EXPECT_LT((*sample.velocity - truth.velocity_body).norm(), 1.2e-4) << "steps of 0.1 mm/s";
      EXPECT_NEAR(sample.altitude_m.value() / (truth.bed_depth_m + truth.height_m), 1, 0.0015)
          << "the driver takes the pitch as that of a gimbal";
    }
    EXPECT_GT(locked, 50);
  }
}

TEST_F(ThroughDrivers, AWaterLinkedDvlIsSetUpAndItsRotationTurnsBothWays) {
  auto with_baud = options(device::Kind::dvl, device(DeviceKind::dvl, "water-linked", 5));
  with_baud.baud = 115200;
  with_baud.mounting = {};
  with_baud.dvl.water_linked = device::WaterLinkedSettings{1490.0, 30 * degree, false};
  const auto made = device::make_byte_driver(with_baud);
  ASSERT_TRUE(made);
  const auto& driver = *made;
  auto config = device(DeviceKind::dvl, "water-linked", 5);
  config.mounting_rad = {0, 0, 30 * degree};  // the DVL knows this angle, the driver does not
  EmulatedLine line(make_emulated_device(config, trajectory_, 1).value(), 115200,
                    [&](wire::Bytes bytes, const Passage& passage) {
                      now_ = passage.ended_at;
                      driver->receive(bytes, now_, *this);
                    });
  line_ = &line;
  driver->restart(start, *this);
  run(line);
  line_ = nullptr;
  EXPECT_FALSE(driver->deadline()) << "every command was answered";
  int locked = 0;
  for (const auto& sample : all<measurement::BottomVelocity>()) {
    if (!sample.velocity || sample.origin.valid_at < at_s(1)) continue;
    ++locked;
    const auto truth = trajectory_.at(sample.origin.valid_at);
    EXPECT_LT((*sample.velocity - truth.velocity_body).norm(), 1.5e-3);
  }
  EXPECT_GT(locked, 50);
}

TEST_F(ThroughDrivers, TheLogsSpeedAtTheTimeItWasTrue) {
  run_line(device::Kind::emlog, device(DeviceKind::emlog, "nmea0183", 2), 4800);
  int speeds = 0;
  for (const auto& sample : all<measurement::WaterSpeed>()) {
    if (!sample.longitudinal_mps || !sample.transverse_mps) continue;
    ++speeds;
    const auto truth = trajectory_.at(sample.origin.valid_at);
    EXPECT_NEAR(*sample.longitudinal_mps, truth.velocity_body.x(), 4e-4);
    // VBW leaves first, so its time on the line is known exactly.
    EXPECT_LT(std::abs(measurement::seconds((sample.origin.valid_at - start) %
                                            std::chrono::milliseconds{500})),
              1e-6);
  }
  EXPECT_GE(speeds, 179);
}

TEST_F(ThroughDrivers, GnssAndDvlAgreeAboutTheVelocityAtTheSurface) {
  run_line(device::Kind::gnss, device(DeviceKind::gnss, "ubx", 5), 38400);
  run_line(device::Kind::dvl, device(DeviceKind::dvl, "pd0", 5), 115200);
  const auto fixes = all<measurement::GnssFix>();
  const auto dvl = all<measurement::BottomVelocity>();
  ASSERT_GT(fixes.size(), 400);
  int compared = 0;
  for (std::size_t i = 0; i < 150; ++i) {  // the turn, before the dive
    ASSERT_TRUE(fixes[i].velocity_ned && dvl[i].velocity);
    const auto& bottom = dvl[i];
    const Vector3d by_dvl =
        frame::body_to_ned({*bottom.roll_rad, *bottom.pitch_rad, *bottom.heading_rad}) *
        *bottom.velocity;
    EXPECT_LT((*fixes[i].velocity_ned - by_dvl).norm(), 3e-3);
    ++compared;
  }
  EXPECT_EQ(compared, 150);
  EXPECT_FALSE(fixes.back().position);  // 20 m down by now
}

}  // namespace line_drivers_test
}  // namespace drydock::emulate
