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

/// A dive in the layout of sonia-auv/matlab: DATA_{IMU,DVL,BARO,MAG}.csv. All times are seconds
/// since the same start. Each sensor has its own axes.
struct PoolRecording {
  std::vector<ImuRow> imu;
  std::vector<TimedVector> dvl;  ///< m/s
  std::vector<TimedPressure> pressure;
  std::vector<TimedVector> magnetic;  ///< gauss
  std::size_t without_bottom;         ///< DVL lines with nan; they are not in `dvl`
};

Read<PoolRecording> read_pool(const std::filesystem::path& folder);

}  // namespace drydock::navigation::test
