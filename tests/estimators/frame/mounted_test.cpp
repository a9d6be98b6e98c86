#include "estimators/frame/mounted.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace drydock::frame::mounted_test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180;

Matrix3d elementary(double roll, double pitch, double yaw) {
  return (AngleAxisd{yaw, Vector3d::UnitZ()} * AngleAxisd{pitch, Vector3d::UnitY()} *
          AngleAxisd{roll, Vector3d::UnitX()})
      .toRotationMatrix();
}

/// An axis at 45 degrees to starboard, on a body that is pitched up.
TEST(Mounted, AHeadAt45DegreesPointsFartherFromTheBowOfAPitchedVehicle) {
  const double pitch = 29.085 * degree;
  const Vector3d down = down_in_body(0, pitch);
  const double turn = heading_beside_sensor(down, elementary(0, 0, 45 * degree));
  EXPECT_NEAR(turn, -std::atan2(std::sin(45 * degree), std::cos(45 * degree) * std::cos(pitch)),
              1e-15);
  EXPECT_NEAR(turn / degree, -48.85, 0.005);
}

TEST(Mounted, TheAnglesOfTheBodyAreThoseOfTheElementaryRotations) {
  for (const Vector3d& mounting : {Vector3d{0, 0, 0}, Vector3d{0, 0, 45}, Vector3d{180, 0, 20},
                                   Vector3d{3, -7, 135}, Vector3d{90, 10, -60}}) {
    const Matrix3d sensor_to_body =
        elementary(mounting.x() * degree, mounting.y() * degree, mounting.z() * degree);
    for (double roll = -60; roll <= 60; roll += 20)
      for (double pitch = -50; pitch <= 50; pitch += 20)
        for (double yaw = -170; yaw <= 170; yaw += 40) {
          const Matrix3d body = elementary(roll * degree, pitch * degree, yaw * degree);
          const Euler sensor = euler(Matrix3d((body * sensor_to_body).transpose()));
          const Euler found = of_body(sensor, sensor_to_body);
          EXPECT_NEAR(wrap_pi(found.roll - roll * degree), 0, 1e-12);
          EXPECT_NEAR(found.pitch, pitch * degree, 1e-12);
          EXPECT_NEAR(wrap_pi(found.yaw - yaw * degree), 0, 1e-12);
          const Vector3d down = body.transpose() * Vector3d::UnitZ();
          EXPECT_LT((down_in_body(roll * degree, pitch * degree) - down).norm(), 1e-15);
          EXPECT_NEAR(
              wrap_pi(sensor.yaw + heading_beside_sensor(down, sensor_to_body) - yaw * degree), 0,
              1e-12);
        }
  }
}

}  // namespace
}  // namespace drydock::frame::mounted_test
