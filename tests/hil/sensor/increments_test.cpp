#include "hil/sensor/increments.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "hil/motion/make_trajectory.hpp"
#include "rig_config/load.hpp"

namespace drydock::sensor {
namespace increments_test {

using Eigen::Vector3d;
using motion::Stamp;
using motion::Truth;
using std::chrono::milliseconds;

const Stamp start = measurement::stamp_from_ns(0);

/// Turns about z at a rate that grows linearly, with a constant force along x.
class Spin final : public motion::Trajectory {
 public:
  Truth at(Stamp time) const override {
    Truth truth;
    truth.at = time;
    truth.angular_rate.z() = 0.5 + 0.1 * measurement::seconds(time - increments_test::start);
    truth.specific_force = {2, 0, 0};
    return truth;
  }
  Stamp start() const override { return increments_test::start; }
  Stamp end() const override { return increments_test::start; }
};

TEST(Increments, AreTheIntegralsOfRateAndForce) {
  const Spin spin;
  IncrementIntegrator imu(spin, start);
  const Increments first = imu.until(start + milliseconds{2000});
  EXPECT_NEAR(first.angle.z(), 0.5 * 2 + 0.1 * 2, 1e-13);
  EXPECT_NEAR(first.velocity.x(), 4, 1e-13);
  const Increments second = imu.until(start + milliseconds{2005});
  EXPECT_NEAR(second.angle.z(), 0.5 * 0.005 + 0.05 * (2.005 * 2.005 - 4), 1e-15);
  EXPECT_EQ(imu.until(start + milliseconds{2005}).angle, Vector3d::Zero());
}

TEST(Increments, AtALeverArmHoldTheCentripetalForceAndTheChangeOfRate) {
  const Spin spin;
  IncrementIntegrator imu(spin, start, {Eigen::Matrix3d::Identity(), {3, 0, 0}});
  const Vector3d velocity = imu.until(start + milliseconds{1000}).velocity;
  const double squares = (0.6 * 0.6 * 0.6 - 0.5 * 0.5 * 0.5) / 0.3;  // integral of w^2
  EXPECT_NEAR(velocity.x(), 2 - 3 * squares, 1e-13);
  EXPECT_NEAR(velocity.y(), 3 * 0.1, 1e-13);
}

TEST(Increments, AreInTheSensorsAxes) {
  const Spin spin;
  Mounting upside_down;
  upside_down.sensor_to_body = Vector3d{1, -1, -1}.asDiagonal();
  IncrementIntegrator imu(spin, start, upside_down);
  const Increments one = imu.until(start + milliseconds{10});
  EXPECT_NEAR(one.angle.z(), -0.5 * 0.01 - 0.05 * 1e-4, 1e-15);
  EXPECT_NEAR(one.velocity.x(), 0.02, 1e-15);
}

// In 10 ms, a thousandth of the paper's noise (0.4 mdeg/sqrt(h), 4 ug/sqrt(Hz)).
TEST(Increments, OfATurningDivingVehicleAreExactToAThousandthOfTheNoiseEach) {
  auto mission =
      rig_config::load_mission(DRYDOCK_SOURCE_DIR "/rig_config/missions/velocity-paper.toml")
          .value();
  mission.legs.erase(mission.legs.begin());  // begins with the dive
  const auto trajectory = motion::make_trajectory(mission, start);
  const double noise_rad = 0.4e-3 * std::numbers::pi / 180 / 60 * 0.1;
  const double noise_mps = 4e-6 * 9.80665 * 0.1;
  IncrementIntegrator coarse(*trajectory, start), fine(*trajectory, start);
  for (int i = 1; i <= 3000; ++i) {
    const Increments one = coarse.until(start + i * milliseconds{10});
    Increments ten;
    for (int k = 9; k >= 0; --k) {
      const Increments part = fine.until(start + i * milliseconds{10} - k * milliseconds{1});
      ten.angle += part.angle;
      ten.velocity += part.velocity;
    }
    EXPECT_LT((one.angle - ten.angle).norm(), 1e-3 * noise_rad) << i;
    EXPECT_LT((one.velocity - ten.velocity).norm(), 1e-3 * noise_mps) << i;
  }
}

}  // namespace increments_test
}  // namespace drydock::sensor
