#pragma once

#include "estimators/frame/attitude.hpp"
#include "estimators/navigation/aided_navigation.hpp"
#include "tests/estimators/navigation/recordings/pool_recording.hpp"

namespace drydock::navigation::test {

/// Properties of the vehicle that are not in the recording. Levers from the IMU, body axes, m.
struct DiveSetup {
  Eigen::Matrix3d imu_to_body, dvl_to_body;
  Eigen::Vector3d dvl_lever, pressure_lever;
  double latitude_rad, density;  ///< kg/m3
  double dvl_sigma_mps, depth_sigma_m;
  NavigationOptions options;
};

struct DiveResult {
  double travelled_m = 0, gap_m = 0;  ///< length of the path; horizontal distance of its ends
  double gap_sigma_m = 0;             ///< sigma of the gap by the filter, root of two variances
  double turned_rad = 0;              ///< by the filter's heading, over the whole dive
  double magnetic_turned_rad = 0;     ///< by the magnetometer; the filter does not use it
  double velocity_nis = 0, depth_nis = 0;  ///< per degree of freedom
  double velocity_rms_mps = 0, depth_rms_m = 0;
  int refused = 0;  ///< rows beyond the gate
};

/// Where a dive is levelled, with the indices of the first readings behind that.
struct AlignedDive {
  double begin_s;
  std::size_t sample, ping, pressed, field;
  NavigationState state;  ///< of the IMU
};

/// Refuses what navigate() refuses.
Read<AlignedDive> aligned(const PoolRecording& dive, const DiveSetup& setup);

/// Above the place where the sensor reads zero, m.
double height_of(const TimedPressure& pressure, const DiveSetup& setup);
/// Against magnetic north, rad.
double magnetic_heading(const Eigen::Vector3d& field_body, const frame::Euler& attitude);

/// Levels over the first 2 s, because the vehicle never rests. Takes the heading from the
/// magnetometer and the velocity from the first DVL line. Refuses a shorter recording.
Read<DiveResult> navigate(const PoolRecording& dive, const DiveSetup& setup);

}  // namespace drydock::navigation::test
