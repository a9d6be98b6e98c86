#include <gtest/gtest.h>

#include <cmath>

#include "drivers/device/make_driver.hpp"
#include "estimators/frame/attitude.hpp"
#include "hil/emulate/lockstep.hpp"
#include "hil/motion/kinematic_trajectory.hpp"
#include "tests/hil/emulate/bench.hpp"

namespace drydock::emulate {
namespace {

using Eigen::Vector3d;
using rig_config::DeviceKind;

// All devices of one vehicle that turns and dives, through real drivers: what comes out is the
// truth at the time for which the driver vouches.
class ThroughDrivers : public testing::Test, protected device::Output {
 protected:
  ThroughDrivers() : trajectory_(mission(), start) {}

  static rig_config::MissionConfig mission() {
    using enum rig_config::LegKind;
    rig_config::MissionConfig mission;
    mission.latitude_rad = 47 * degree;
    mission.depth_m = 0;
    mission.speed_mps = 2;
    mission.ocean.bed.depth_m = 60;
    mission.legs = {
        {.kind = turn, .duration_s = 30, .turn_rad = 1.2, .speed_mps = 2.5, .roll_rad = -0.1},
        {.kind = dive, .duration_s = 60, .depth_change_m = 20, .speed_mps = 2}};
    return mission;
  }

  static device::DriverOptions options(device::Kind kind, const rig_config::DeviceConfig& config) {
    device::DriverOptions options;
    options.kind = kind;
    options.protocol = config.protocol;
    options.water.density_kgm3 = config.water_density_kgm3;
    options.mounting = {config.mounting_rad[0], config.mounting_rad[1], config.mounting_rad[2]};
    if (config.maker == rig_config::DvlMaker::water_linked) {
      options.dvl.maker = device::DvlMaker::water_linked;
    }
    return options;
  }

  // Runs for the two legs and gathers the measurements.
  void run_line(device::Kind kind, const rig_config::DeviceConfig& config, unsigned baud) {
    auto with_baud = options(kind, config);
    with_baud.baud = baud;
    const auto made = device::make_byte_driver(with_baud);
    ASSERT_TRUE(made);
    const auto& driver = *made;
    driver->restart(start, *this);
    EmulatedLine line(make_emulated_device(config, trajectory_, 1).value(), baud,
                      [&](wire::Bytes bytes, const Passage& passage) {
                        driver->receive(bytes, passage.ended_at, *this);
                      });
    run(line);
  }

  void run_bus(device::Kind kind, const rig_config::DeviceConfig& config) {
    const auto made = device::make_frame_driver(options(kind, config));
    ASSERT_TRUE(made);
    const auto& driver = *made;
    EmulatedBus bus(250'000, [&](const wire::CanFrame& frame, std::size_t, const Passage& passage) {
      now_ = passage.ended_at;
      driver->receive(frame, now_, *this);
    });
    bus_ = &bus;
    now_ = start;
    driver->restart(start, *this);
    bus.add(make_emulated_device(config, trajectory_, 1).value());
    run(bus);
  }

  void run(shell::Actor& actor) {
    shell::Lockstep lockstep(start);
    lockstep.add(actor);
    lockstep.run_until(at_s(90));
  }

  template <class Sample>
  std::vector<Sample> all() const {
    std::vector<Sample> found;
    for (const auto& m : measurements_) {
      if (const auto* sample = std::get_if<Sample>(&m)) found.push_back(*sample);
    }
    return found;
  }

  void publish(const measurement::Measurement& m) override { measurements_.push_back(m); }
  void send(wire::Bytes bytes) override {
    if (line_) line_->receive(bytes, now_);
  }
  void send(const wire::CanFrame& frame) override { bus_->receive(frame, now_); }
  void report(std::string_view what) override { ADD_FAILURE() << what; }

  motion::KinematicTrajectory trajectory_;
  std::vector<measurement::Measurement> measurements_;
  EmulatedLine* line_ = nullptr;
  EmulatedBus* bus_ = nullptr;
  Stamp now_ = start;
};

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
  for (const char* protocol : {"water-linked", "nortek"}) {
    measurements_.clear();
    auto config = device(DeviceKind::dvl, protocol, 5);
    config.emulate.latency_s = 0.075;  // not told to the driver
    run_line(device::Kind::dvl, config, 115200);
    int locked = 0;
    const auto samples = all<measurement::BottomVelocity>();
    EXPECT_EQ(samples.size(), 450);
    for (const auto& sample : samples) {
      const auto truth = trajectory_.at(sample.origin.valid_at);
      if (!sample.velocity) continue;  // the bed is further than the beams reach
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

TEST_F(ThroughDrivers, AWaterLinkedDvlIsSetUpAndItsRotationTurnsBothWays) {
  auto with_baud = options(device::Kind::dvl, device(DeviceKind::dvl, "water-linked", 5));
  with_baud.baud = 115200;
  with_baud.mounting = {};
  with_baud.dvl.water_linked = device::WaterLinkedSettings{1490.0, 30 * degree, false};
  const auto made = device::make_byte_driver(with_baud);
  ASSERT_TRUE(made);
  const auto& driver = *made;
  auto config = device(DeviceKind::dvl, "water-linked", 5);
  config.mounting_rad = {0, 0, 30 * degree};  // the DVL is told, the driver is not
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
    // VBW leaves first: what the line takes is known to the last byte.
    EXPECT_LT(std::abs(measurement::seconds((sample.origin.valid_at - start) %
                                            std::chrono::milliseconds{500})),
              1e-6);
  }
  EXPECT_GE(speeds, 179);
}

TEST_F(ThroughDrivers, EveryImusForceAndRate) {
  constexpr double milli_g = 9.80665e-3;
  for (const auto& [protocol, force_step, rate_step] :
       {std::tuple{"cia404-imu", 2e-6, 1e-8}, std::tuple{"aceinna", 0.01, 1.0 / 128 * degree},
        std::tuple{"epson-g550", 0.2 * milli_g, 0.008 * degree},
        std::tuple{"epson-g552", 0.4 * milli_g, 0.01515 * degree},
        std::tuple{"xsens", 1.0 / 256, 1.0 / 512}}) {
    measurements_.clear();
    run_bus(device::Kind::imu, device(DeviceKind::imu, protocol, 100));
    const auto samples = all<measurement::ImuSample>();
    EXPECT_GE(samples.size(), 8970) << protocol;
    for (const auto& sample : samples) {
      // The driver's time is within a frame of the truth's; motion in 1 ms stays below the margin.
      const auto truth = trajectory_.at(sample.origin.valid_at);
      ASSERT_LT((sample.specific_force - truth.specific_force).norm(), force_step + 5e-4);
      ASSERT_LT((sample.angular_rate - truth.angular_rate).norm(), rate_step + 5e-5);
    }
  }
}

TEST_F(ThroughDrivers, DepthIsWrongByTheDensityThatTheDriverDoesNotKnow) {
  auto config = device(DeviceKind::depth, "nmea2000", 5);
  config.water_density_kgm3 = 1000;  // the ocean's is 1025
  run_bus(device::Kind::depth, config);
  int compared = 0;
  for (const auto& sample : all<measurement::DepthSample>()) {
    if (!sample.depth_m) continue;
    const double truth = -trajectory_.at(sample.origin.valid_at).height_m;
    EXPECT_NEAR(*sample.depth_m, truth * 1.025, 0.02);  // standard against local gravity: 3 mm
    compared += truth > 10;
  }
  EXPECT_GT(compared, 100);
}

TEST_F(ThroughDrivers, DepthAndSounderAgreeAboutTheBed) {
  run_bus(device::Kind::depth, device(DeviceKind::depth, "nmea2000", 5));
  std::optional<double> depth;
  int compared = 0;
  for (const auto& sample : all<measurement::DepthSample>()) {
    if (sample.depth_m) depth = sample.depth_m;
    if (!sample.altitude_m || !depth) continue;
    ++compared;
    EXPECT_NEAR(*depth + *sample.altitude_m, 60, 0.02);  // standard against local gravity: 3 mm
  }
  EXPECT_GT(compared, 80);  // one a second
}

TEST_F(ThroughDrivers, ActuatorsComeBackWithTheirSigns) {
  run_bus(device::Kind::actuator, device(DeviceKind::actuator, "nmea2000", 10));
  int rudders = 0;
  for (const auto& sample : all<measurement::ActuatorState>()) {
    const auto truth = trajectory_.at(sample.origin.valid_at);
    if (sample.rudder_rad) {
      ++rudders;
      EXPECT_NEAR(*sample.rudder_rad, truth.rudder_rad, 3e-4);
    }
    if (sample.stern_plane_rad) {
      EXPECT_NEAR(*sample.stern_plane_rad, truth.stern_plane_rad, 3e-4);
    }
    if (sample.propeller_radps) {
      EXPECT_NEAR(*sample.propeller_radps, truth.propeller_radps, 0.05);
    }
  }
  EXPECT_GT(rudders, 880);
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

}  // namespace
}  // namespace drydock::emulate
