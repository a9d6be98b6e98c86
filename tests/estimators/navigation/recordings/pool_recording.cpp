#include "tests/estimators/navigation/recordings/pool_recording.hpp"

namespace drydock::navigation::test {

Read<PoolRecording> read_pool(const std::filesystem::path& folder) {
  const auto imu = read_csv(folder / "DATA_IMU.csv", 7, 0);
  const auto dvl = read_csv(folder / "DATA_DVL.csv", 4, 0, true);
  const auto pressure = read_csv(folder / "DATA_BARO.csv", 2, 0);
  const auto magnetic = read_csv(folder / "DATA_MAG.csv", 4, 0);
  for (const auto* table : {&imu, &dvl, &pressure, &magnetic})
    if (table->has_error()) return table->error();

  PoolRecording dive{};
  for (const auto& row : *imu)
    dive.imu.push_back({row[0], {row[4], row[5], row[6]}, {row[1], row[2], row[3]}});
  for (const auto& row : *dvl) {
    const Eigen::Vector3d velocity{row[1], row[2], row[3]};
    if (velocity.hasNaN())
      ++dive.without_bottom;
    else
      dive.dvl.push_back({row[0], velocity});
  }
  for (const auto& row : *pressure) dive.pressure.push_back({row[0], row[1]});
  for (const auto& row : *magnetic) dive.magnetic.push_back({row[0], {row[1], row[2], row[3]}});
  return dive;
}

}  // namespace drydock::navigation::test
