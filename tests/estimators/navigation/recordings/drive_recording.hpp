#pragma once

#include "estimators/frame/geodetic.hpp"
#include "tests/estimators/navigation/recordings/recording.hpp"
#include "tests/estimators/navigation/recordings/table.hpp"

namespace drydock::navigation::test {

/// A line of an RTKLIB solution file.
struct RtkFix {
  double t;
  frame::Position position;
  int quality;  ///< 1 fixed, 2 float
  Eigen::Vector3d sigma_m, velocity_ned;
};

/// A drive in the layout of rtklibexplorer/GNSS_IMU: gnss*.pos (RTKLIB solution with velocity, GPS
/// time), imu*.csv (g, deg/s, ms of the IMU's clock) and imu*.csv.tag (RTKLIB's time tags: when
/// which byte of the file was written). Times: s of the day of the first fix.
struct DriveRecording {
  std::vector<ImuRow> imu;
  std::vector<RtkFix> fixes;
  double clock_rate;     ///< s of the logger's clock per s of the IMU's count
  double period_s;       ///< of the IMU's own samples; 0 where no row is repeated
  std::size_t repeated;  ///< rows that brought what the row before brought
  std::size_t lost;      ///< samples that no row brought, filled in from their neighbours
};

/// The IMU's clock is tied to the logger's by the line of least squares through the time tags; what
/// delays every tag alike stays in. The IMU's own samples are put back in their places.
Read<DriveRecording> read_drive(const std::filesystem::path& folder);

}  // namespace drydock::navigation::test
