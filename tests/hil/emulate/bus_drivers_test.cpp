// The output of CAN drivers for emulated devices: force and rate, depth, actuators.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/hil/emulate/through_drivers.hpp"

namespace drydock::emulate {
namespace bus_drivers_test {

using rig_config::DeviceKind;

TEST_F(ThroughDrivers, EveryImusForceAndRate) {
  constexpr double milli_g = 9.80665e-3;
  for (const auto& [protocol, force_step, rate_step] :
       {std::tuple{"cia404-imu", 2e-6, 1e-8}, std::tuple{"aceinna", 0.01, 1.0 / 128 * degree},
        std::tuple{"microstrain-mv5", 0.01, 1.0 / 128 * degree},
        std::tuple{"epson-g550", 0.2 * milli_g, 0.008 * degree},
        std::tuple{"epson-g552", 0.4 * milli_g, 0.01515 * degree}, std::tuple{"sbg", 0.01, 0.001},
        std::tuple{"xsens", 1.0 / 256, 1.0 / 512}}) {
    measurements_.clear();
    run_bus(device::Kind::imu, device(DeviceKind::imu, protocol, 100));
    const auto samples = all<measurement::ImuSample>();
    EXPECT_GE(samples.size(), 8970) << protocol;
    for (const auto& sample : samples) {
      // The driver's time differs from the truth's by less than a frame. The motion in 1 ms is
      // below the margin.
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
    EXPECT_NEAR(*sample.depth_m, truth * 1.025, 0.02);  // standard gravity instead of local
                                                        // gravity: 3 mm
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
    EXPECT_NEAR(*depth + *sample.altitude_m, 60, 0.02);  // standard gravity instead of local
                                                         // gravity: 3 mm
  }
  EXPECT_GT(compared, 80);  // one per second
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

}  // namespace bus_drivers_test
}  // namespace drydock::emulate
