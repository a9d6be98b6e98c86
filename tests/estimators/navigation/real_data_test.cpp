#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "tests/estimators/navigation/recordings/vehicles.hpp"

namespace drydock::navigation::real_data_test {
namespace {

namespace fs = std::filesystem;
using namespace navigation::test;

fs::path ins() {
  const char* named = std::getenv("DRYDOCK_CORPORA");
  return fs::path{named ? named : DRYDOCK_SOURCE_DIR "/../shared/corpora"} / "ins";
}

double rms(const std::vector<double>& values) {
  double square = 0;
  for (const double value : values) square += value * value;
  return std::sqrt(square / static_cast<double>(values.size()));
}

TEST(RealData, ACarComesThroughFifteenSecondsWithoutFixes) {
  const fs::path folder = ins() / "rtklibexplorer_GNSS_IMU/drive_0708";
  if (!fs::exists(folder)) GTEST_SKIP() << "corpora absent: " << folder;
  const auto drive = read_drive(folder);
  ASSERT_TRUE(drive.has_value()) << drive.error().line;
  const auto aided = navigate(*drive, car(), {60, 0});
  const auto gaps = navigate(*drive, car(), {60, 15});
  ASSERT_TRUE(aided.has_value()) << aided.error().line;
  ASSERT_TRUE(gaps.has_value()) << gaps.error().line;
  const double worst = *std::max_element(gaps->gap_end_m.begin(), gaps->gap_end_m.end());
  std::printf("| %s | %.3f | %.2f | %zu | %.2f | %.2f | %.2f |\n", folder.filename().c_str(),
              aided->aided_rms_m, aided->nis, gaps->gap_end_m.size(), rms(gaps->gap_end_m), worst,
              rms(gaps->gap_sigma_m));
  EXPECT_EQ(gaps->gap_end_m.size(), 8U);
  EXPECT_LT(aided->aided_rms_m, 0.10);
  EXPECT_LT(rms(gaps->gap_end_m),
            12);  // more than the filter expects: docs/estimators/real-data.md
  EXPECT_LT(worst, 20);
}

TEST(RealData, AnAuvInAPoolComesBackToWhereItBegan) {
  if (!fs::exists(ins() / "sonia_pool")) GTEST_SKIP() << "corpora absent: " << ins();
  for (const auto& run : fs::directory_iterator{ins() / "sonia_pool"}) {
    SCOPED_TRACE(run.path());
    const auto dive = read_pool(run.path());
    ASSERT_TRUE(dive.has_value()) << dive.error().line;
    const auto result = navigate(*dive, sonia());
    ASSERT_TRUE(result.has_value()) << result.error().line;
    std::printf("| %s | %.1f | %.2f | %.0f | %.0f | %.2f | %.2f |\n", run.path().filename().c_str(),
                result->travelled_m, result->gap_m, result->turned_rad / degree,
                result->magnetic_turned_rad / degree, result->velocity_nis, result->depth_nis);
    EXPECT_GT(result->travelled_m, 15);
    EXPECT_LT(result->gap_m, 2.5);
    EXPECT_GT(result->velocity_nis, 0.7);
    EXPECT_LT(result->velocity_nis, 1.8);
    EXPECT_GT(result->depth_nis, 0.3);
    EXPECT_LT(result->depth_nis, 1.3);
  }
}

TEST(RealData, WhatIsNotARecordingIsRefusedInOneLine) {
  const fs::path folder = fs::path{testing::TempDir()} / "drydock_pool_recording";
  fs::create_directories(folder);
  const auto write = [&](const char* file, const char* text) {
    std::ofstream{folder / file} << text;
  };
  write("DATA_IMU.csv", "0,0,0,9.8,0,0,0\n0.01,0,0,9.8,0,0,0\n");
  write("DATA_DVL.csv", "0,1,2,3\n0.3,nan,nan,nan\n");
  write("DATA_BARO.csv", "0,101325\n");
  write("DATA_MAG.csv", "0,1,0,0\n");
  const auto good = read_pool(folder);
  ASSERT_TRUE(good.has_value()) << good.error().line;
  EXPECT_EQ(good->imu.size(), 2U);
  EXPECT_EQ(good->dvl.size(), 1U);
  EXPECT_EQ(good->without_bottom, 1U);
  EXPECT_EQ(navigate(*good, sonia()).error().line,
            "alignment: the dive is over before it is levelled");

  write("DATA_IMU.csv", "0,0,0,9.8,0,0,0\n0.01,0,0,x,0,0,0\n");
  EXPECT_EQ(read_pool(folder).error().line,
            (folder / "DATA_IMU.csv").string() + ":2: not a number: x");
  write("DATA_IMU.csv", "1,0,0,9.8,0,0,0\n0.01,0,0,9.8,0,0,0\n");
  EXPECT_EQ(read_pool(folder).error().line,
            (folder / "DATA_IMU.csv").string() + ":2: time runs backwards");
  write("DATA_IMU.csv", "0,0,0,9.8\n");
  EXPECT_EQ(read_pool(folder).error().line,
            (folder / "DATA_IMU.csv").string() + ":1: 4 fields, expected 7");
  EXPECT_EQ(read_drive(folder).error().line, folder.string() + ": 0 files *.pos, expected one");
  fs::remove_all(folder);
}

}  // namespace
}  // namespace drydock::navigation::real_data_test
