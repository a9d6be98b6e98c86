#pragma once

#include "estimators/navigation/aided_navigation.hpp"
#include "tests/estimators/navigation/recordings/drive_recording.hpp"

namespace drydock::navigation::test {

/// What the recording does not say of the vehicle that made it.
struct DriveSetup {
  Eigen::Matrix3d imu_to_body;
  Eigen::Vector3d antenna;  ///< from the IMU, body axes, m
  double imu_delay_s;       ///< of the logger's time behind the fixes'
  double fix_sigma_m;       ///< added in square to the receiver's own
  NavigationOptions options;
};

/// Of every `every_s` seconds under way the last `length_s` are without fixes. 0: none are.
/// `early_s`: by how much each gap comes earlier.
struct Gaps {
  double every_s = 60, length_s = 0, early_s = 0;
};

struct DriveResult {
  double aided_rms_m = 0;  ///< horizontal, against each fix before it is used, but after gaps
  double nis = 0;          ///< mean normalised innovation square per degree of freedom
  std::vector<double> gap_end_m;    ///< horizontal error at each gap's last withheld fix
  std::vector<double> gap_sigma_m;  ///< and what the filter expects, root of the two variances
  std::vector<double> gap_nees;     ///< normalised by the covariance, per degree of freedom
};

/// Levels over the rest at the start, carries that attitude by the gyros until the car makes 2 m/s,
/// takes the heading from the course there, and runs the filter over the rest. Refused when the
/// recording does not rest first or never moves.
Read<DriveResult> navigate(const DriveRecording& drive, const DriveSetup& setup, const Gaps& gaps);

}  // namespace drydock::navigation::test
