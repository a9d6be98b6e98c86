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
/// time), imu*.csv (g, deg/s, ms of the IMU's clock) and imu*.csv.tag (RTKLIB's time tags, which
/// say when each byte of the file was written). Times are seconds of the day of the first fix.
struct DriveRecording {
  std::vector<ImuRow> imu;
  std::vector<RtkFix> fixes;
  double clock_rate;     ///< s of the logger's clock per s of the IMU's count
  double period_s;       ///< of the IMU's own samples; 0 if no row is repeated
  std::size_t repeated;  ///< rows with the same sample as the row before
  std::size_t lost;      ///< samples in no row; their neighbours fill them in
};

/// A least-squares line through the time tags ties the IMU's clock to the logger's clock. A
/// constant delay of all tags remains. The IMU's own samples get their right places back.
Read<DriveRecording> read_drive(const std::filesystem::path& folder);

}  // namespace drydock::navigation::test
