#pragma once

#include "tests/estimators/navigation/recordings/recording.hpp"
#include "tests/estimators/navigation/recordings/table.hpp"

namespace drydock::navigation::test {

struct TimedVector {
  double t;
  Eigen::Vector3d value;
};
struct TimedPressure {
  double t, pascal;
};

/// A dive in the layout of sonia-auv/matlab: DATA_{IMU,DVL,BARO,MAG}.csv, all in s since the same
/// start; each sensor in its own axes.
struct PoolRecording {
  std::vector<ImuRow> imu;
  std::vector<TimedVector> dvl;  ///< m/s
  std::vector<TimedPressure> pressure;
  std::vector<TimedVector> magnetic;  ///< gauss
  std::size_t without_bottom;         ///< DVL lines that say nan: not in `dvl`
};

Read<PoolRecording> read_pool(const std::filesystem::path& folder);

}  // namespace drydock::navigation::test
