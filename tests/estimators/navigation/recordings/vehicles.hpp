#pragma once

#include <numbers>

#include "estimators/frame/attitude.hpp"
#include "tests/estimators/navigation/recordings/aided_dive.hpp"
#include "tests/estimators/navigation/recordings/aided_drive.hpp"

/// The two vehicles by the descriptions of their owners, and our chosen values:
/// docs/estimators/real-data.md.
namespace drydock::navigation::test {

inline constexpr double degree = std::numbers::pi / 180;

/// TDK ICM-45686 and u-blox X20 on a car.
inline DriveSetup car() {
  NavigationOptions o;
  o.position_m = 0.05, o.height_m = 0.05, o.velocity_mps = 0.1;
  o.alignment_rad = Eigen::Vector3d{1, 1, 10} * degree;
  o.gyro_bias_radps = 0.02 * degree;
  o.accel_bias_mps2 = 0.1;
  // The source of each value: docs/estimators/real-data.md.
  o.angle_noise_rad = 0.005 * degree;
  o.velocity_noise_mps = 0.009;
  o.gyro_bias_walk_radps = 4e-4 * degree;
  o.accel_bias_walk_mps2 = 7e-6 * 9.80665;
  o.height_noise_m = o.height_loop_tau_s = 0;
  // Euler angles by Groves from the body axes of the car to the axes of the IMU.
  const frame::Euler imu{180 * degree, -6.79 * degree, 185.35 * degree};
  return {frame::ned_to_body(imu), {0, -0.05, 0}, 0.26, 0.015, o};
}

/// The SONIA vehicle of 2016: IMU upside down, DVL turned by -45 degrees.
inline DiveSetup sonia() {
  NavigationOptions o;
  o.position_m = 0.01, o.height_m = 0.1, o.velocity_mps = 0.1;
  o.alignment_rad = Eigen::Vector3d{5, 5, 5} * degree;
  o.gyro_bias_radps = 0.25 * degree;
  o.accel_bias_mps2 = 0.05;
  o.angle_noise_rad = 0.03 * degree;
  o.velocity_noise_mps = 0.02;
  o.gyro_bias_walk_radps = 1e-5;
  o.accel_bias_walk_mps2 = 1e-3;
  o.height_noise_m = o.height_loop_tau_s = 0;
  const Eigen::Matrix3d upside_down = Eigen::Vector3d{1, -1, -1}.asDiagonal();
  return {upside_down,
          frame::ned_to_body({0, 0, -45 * degree}),
          {0, 0, 0.15},
          {0, -0.10, -0.5},
          45.5 * degree,
          1000,
          0.02,
          0.02,
          o};
}

}  // namespace drydock::navigation::test
