#include "tests/hil/sensor/inertial_navigation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hil/motion/make_trajectory.hpp"
#include "rig_config/load.hpp"

/// The truth of 5.5 h, reproduced from the increments of a perfect IMU.
namespace drydock::sensor {
namespace inertial_navigation_test {

// The growth of the paper's Table 2 in 5.5 h.
const double hours = 5.5;
const double angle_noise_rad = 0.4e-3 * std::numbers::pi / 180 * std::sqrt(hours);
const double velocity_noise_mps = 4e-6 * 9.80665 * std::sqrt(3600 * hours);

TEST(InertialNavigation, FindsTheVelocityPapersMissionAgainFromIncrements) {
  const auto mission =
      rig_config::load_mission(DRYDOCK_SOURCE_DIR "/rig_config/missions/velocity-paper.toml")
          .value();
  const auto start = measurement::stamp_from_ns(0);
  const std::chrono::milliseconds interval{10};
  const auto trajectory = motion::make_trajectory(mission, start);
  IncrementIntegrator imu(*trajectory, start);
  test::InertialNavigation navigation(trajectory->at(start));
  test::InertialNavigation::Error worst{0, 0, 0};
  double height_loop_mps2 = 0;
  for (auto now = start; now < trajectory->end(); now += 2 * interval) {
    const Increments first = imu.until(now + interval), second = imu.until(now + 2 * interval);
    navigation.advance(first, second, 0.01);
    const motion::Truth truth = trajectory->at(now + 2 * interval);
    height_loop_mps2 =
        std::max(height_loop_mps2, std::abs(navigation.hold_height(truth.height_m, 0.02)));
    const auto error = navigation.against(truth);
    worst.position_m = std::max(worst.position_m, error.position_m);
    worst.velocity_mps = std::max(worst.velocity_mps, error.velocity_mps);
    worst.attitude_rad = std::max(worst.attitude_rad, error.attitude_rad);
  }
  EXPECT_LT(worst.position_m, 0.01);
  EXPECT_LT(worst.velocity_mps, 1e-3 * velocity_noise_mps);
  EXPECT_LT(worst.attitude_rad, 1e-3 * angle_noise_rad);
  EXPECT_LT(height_loop_mps2, 1e-8);  // 1 ng: the loop only stabilises the height
}

}  // namespace inertial_navigation_test
}  // namespace drydock::sensor
