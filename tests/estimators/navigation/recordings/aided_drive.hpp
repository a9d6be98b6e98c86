#pragma once

#include "estimators/navigation/aided_navigation.hpp"
#include "tests/estimators/navigation/recordings/drive_recording.hpp"

namespace drydock::navigation::test {

/// Properties of the vehicle that are not in the recording.
struct DriveSetup {
  Eigen::Matrix3d imu_to_body;
  Eigen::Vector3d antenna;  ///< from the IMU, body axes, m
  double imu_delay_s;       ///< delay of the logger's time against that of the fixes
  double fix_sigma_m;       ///< added to the sigma of the receiver as a root sum of squares
  NavigationOptions options;
};

/// The last `length_s` of every `every_s` seconds of motion have no fixes. 0: no gaps.
/// `early_s`: each gap comes earlier by this time.
struct Gaps {
  double every_s = 60, length_s = 0, early_s = 0;
};

struct DriveResult {
  double aided_rms_m =
      0;           ///< horizontal, against each fix before its use, without those after gaps
  double nis = 0;  ///< mean normalised innovation square per degree of freedom
  std::vector<double> gap_end_m;    ///< horizontal error at the last fix in each gap
  std::vector<double> gap_sigma_m;  ///< sigma of it by the filter, root of the two variances
  std::vector<double> gap_nees;     ///< normalised by the covariance, per degree of freedom
};

/// Where the car begins to move, and the IMU from there on in body axes, in the time of the fixes.
struct AlignedDrive {
  std::size_t fix;        ///< the first one that finds it moving
  NavigationState state;  ///< of the IMU, at the first sample
  std::vector<ImuRow> imu;
};

/// Refuses what navigate() refuses.
Read<AlignedDrive> aligned(const DriveRecording& drive, const DriveSetup& setup);

/// Levels while the car is at rest at the start. Carries this attitude with the gyros until the car
/// moves at 2 m/s and takes the heading from the course there. Then it runs the filter to the end.
/// Refuses a recording that does not start at rest or never moves.
Read<DriveResult> navigate(const DriveRecording& drive, const DriveSetup& setup, const Gaps& gaps);

}  // namespace drydock::navigation::test
