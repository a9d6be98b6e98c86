#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "tests/estimators/navigation/recordings/at_hand.hpp"
#include "tests/estimators/navigation/recordings/vehicles.hpp"

namespace drydock::navigation::real_data_test {
namespace {

namespace fs = std::filesystem;
using namespace navigation::test;

double rms(const std::vector<double>& values) {
  double square = 0;
  for (const double value : values) square += value * value;
  return std::sqrt(square / static_cast<double>(values.size()));
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

class RealDrive : public testing::Test {
 protected:
  void SetUp() override {
    const fs::path folder = ins() / "rtklibexplorer_GNSS_IMU/drive_0708";
    if (!fs::exists(folder)) GTEST_SKIP() << "corpora absent: " << folder;
    auto read = read_drive(folder);
    ASSERT_TRUE(read.has_value()) << read.error().line;
    drive = std::move(*read);
  }
  DriveResult through(const Gaps& gaps, const DriveSetup& setup = car()) const {
    const auto result = navigate(drive, setup, gaps);
    if (result.has_error()) throw std::runtime_error(result.error().line);
    return *result;
  }
  DriveRecording drive;
};

TEST_F(RealDrive, TheLoggerReadsSomeSamplesTwiceAndOthersNever) {
  // 1138 of the 54 860 rows repeat the row before. An IMU at 100.5 Hz explains almost all of them.
  std::printf("| period %.4f ms | repeated %zu | lost %zu |\n", drive.period_s * 1e3,
              drive.repeated, drive.lost);
  EXPECT_EQ(drive.repeated, 1138U);
  EXPECT_NEAR(drive.period_s, 9.949e-3, 1e-6);
  EXPECT_EQ(drive.imu.size(), 54860 - 1138 + drive.lost);
  EXPECT_NEAR(static_cast<double>(drive.lost), 548.57 / 9.949e-3 - (54860 - 1138), 5);
}

TEST_F(RealDrive, ACarComesThroughFifteenSecondsWithoutFixes) {
  const DriveResult aided = through({60, 0});
  const DriveResult gaps = through({60, 15});
  const double worst = *std::max_element(gaps.gap_end_m.begin(), gaps.gap_end_m.end());
  std::printf("| drive_0708 | %.3f | %.2f | %zu | %.2f | %.2f | %.2f | %.2f |\n", aided.aided_rms_m,
              aided.nis, gaps.gap_end_m.size(), rms(gaps.gap_end_m), worst, rms(gaps.gap_sigma_m),
              mean(gaps.gap_nees));
  EXPECT_EQ(gaps.gap_end_m.size(), 8U);
  EXPECT_LT(aided.aided_rms_m, 0.04);
  EXPECT_LT(rms(gaps.gap_end_m), 2.5);
  EXPECT_LT(worst, 4);
  // The 95 % range of chi-square with 16 degrees of freedom, divided by 16.
  EXPECT_GT(mean(gaps.gap_nees), 6.91 / 16);
  EXPECT_LT(mean(gaps.gap_nees), 28.8 / 16);
}

TEST_F(RealDrive, TheEightGapsAreNotBetterThanOthers) {
  std::vector<double> ends, expected, nees;
  for (const double early : {0, 7, 15, 22, 30, 37}) {
    const DriveResult gaps = through({60, 15, early});
    ends.insert(ends.end(), gaps.gap_end_m.begin(), gaps.gap_end_m.end());
    expected.insert(expected.end(), gaps.gap_sigma_m.begin(), gaps.gap_sigma_m.end());
    nees.insert(nees.end(), gaps.gap_nees.begin(), gaps.gap_nees.end());
  }
  std::printf("| drive_0708, moved | | | %zu | %.2f | %.2f | %.2f | %.2f |\n", ends.size(),
              rms(ends), *std::max_element(ends.begin(), ends.end()), rms(expected), mean(nees));
  EXPECT_GE(ends.size(), 48U);
  EXPECT_LT(rms(ends), 2.5);
  EXPECT_GT(mean(nees), 6.91 / 16);  // the gaps overlap, so they count as eight independent ones
  EXPECT_LT(mean(nees), 28.8 / 16);
}

TEST_F(RealDrive, TheDelayIsWhereTheInnovationsAreLeast) {
  double nis[3];
  for (int i = 0; i < 3; ++i) {
    DriveSetup setup = car();
    setup.imu_delay_s += 0.02 * (i - 1);
    nis[i] = through({60, 0}, setup).nis;
  }
  std::printf("| NIS, delay -20 ms, as set, +20 ms | %.3f | %.3f | %.3f |\n", nis[0], nis[1],
              nis[2]);
  EXPECT_LT(nis[1], nis[0]);
  EXPECT_LT(nis[1], nis[2]);
}

TEST(RealData, AnAuvInAPoolComesBackToWhereItBegan) {
  if (!fs::exists(ins() / "sonia_pool")) GTEST_SKIP() << "corpora absent: " << ins();
  for (const auto& run : fs::directory_iterator{ins() / "sonia_pool"}) {
    SCOPED_TRACE(run.path());
    const auto dive = read_pool(run.path());
    ASSERT_TRUE(dive.has_value()) << dive.error().line;
    const auto result = navigate(*dive, sonia());
    ASSERT_TRUE(result.has_value()) << result.error().line;
    std::printf("| %s | %.1f | %.2f | %.2f | %.0f | %.0f | %.2f | %.2f |\n",
                run.path().filename().c_str(), result->travelled_m, result->gap_m,
                result->gap_sigma_m, result->turned_rad / degree,
                result->magnetic_turned_rad / degree, result->velocity_nis, result->depth_nis);
    EXPECT_GT(result->travelled_m, 15);
    // The magnetometer, which does not aid, shows that the crew stopped before the end of the full
    // round. The gap is the chord of the missing part, within the 95 % range that the filter
    // expects on two equal axes.
    const double turned = std::abs(result->magnetic_turned_rad);
    const double chord = 2 * result->travelled_m / turned * std::sin(M_PI - turned / 2);
    EXPECT_NEAR(result->gap_m, chord, 1.73 * result->gap_sigma_m);
    // The sigmas are our own round numbers, right within a factor of the square root of two.
    EXPECT_GT(result->velocity_nis, 0.5);
    EXPECT_LT(result->velocity_nis, 2);
    EXPECT_GT(result->depth_nis, 0.5);
    EXPECT_LT(result->depth_nis, 2);
  }
}

// An IMU at rest under vibration, with another rate, polled every 10 ms, in a folder with other
// names.
TEST(RealData, AnotherDriveOfTheSameLayoutIsReadWithoutItsLostSamples) {
  const fs::path folder = fs::path{testing::TempDir()} / "drydock_drive_recording";
  fs::create_directories(folder);
  constexpr double period = 1 / 98.7, phase = -0.004, seconds = 120;
  const auto shaken = [](double t) { return 5 * std::sin(2 * M_PI * 29 * t) + std::sin(50 * t); };
  std::ofstream csv{folder / "imu_0001.csv"}, pos{folder / "gnss_0001.pos"};
  std::ofstream tags{folder / "imu_0001.csv.tag", std::ios::binary};
  std::string header = "TIMETAG";
  header.resize(64);
  const std::uint32_t start = 1'752'003'261;
  const double fraction = 0.5;
  tags << header;
  tags.write(reinterpret_cast<const char*>(&start), sizeof start);
  tags.write(reinterpret_cast<const char*>(&fraction), sizeof fraction);
  std::uint32_t bytes = 0;
  for (int row = 0; row < static_cast<int>(seconds * 100); ++row) {
    const double turn = std::ceil(row * 10 / 2.048) * 2.048e-3;
    const double taken = std::floor((turn - phase) / period) * period + phase;
    char line[128];
    bytes += static_cast<std::uint32_t>(std::snprintf(
        line, sizeof line, "%.6f,%.6f,1.000000,%.6f,%.6f,%.6f,%.0f\n", shaken(taken + 1),
        shaken(taken + 2), shaken(taken + 3), shaken(taken), shaken(taken + 5), turn * 1e3));
    csv << line;
    const std::uint32_t tag[2] = {static_cast<std::uint32_t>(turn * 1e3), bytes};
    tags.write(reinterpret_cast<const char*>(tag), sizeof tag);
  }
  pos << "% of another program\n2024/01/31 23:59:59.750 60 10 5 1 9 .01 .01 .02 0 0 0 0 0 1 2 3 "
         ".1 .1 .1 0 0 0\n2024/02/01 00:00:00.000 60 10 5 2 9 .01 .01 .02 0 0 0 0 0 1 2 3 "
         ".1 .1 .1 0 0 0\n";
  csv.close(), pos.close(), tags.close();

  const auto drive = read_drive(folder);
  ASSERT_TRUE(drive.has_value()) << drive.error().line;
  EXPECT_NEAR(drive->fixes[1].t - drive->fixes[0].t, 0.25, 1e-9);  // across midnight
  EXPECT_EQ(drive->fixes[1].quality, 2);
  EXPECT_EQ(drive->fixes[0].velocity_ned, Eigen::Vector3d(1, 2, -3));
  EXPECT_NEAR(drive->period_s, period, 1e-7);
  EXPECT_GT(drive->lost, 50U);
  EXPECT_EQ(drive->imu.size(),
            static_cast<std::size_t>(seconds * 100) - drive->repeated + drive->lost);
  int misplaced = 0;
  double square = 0;
  const double first = drive->imu.front().t;
  for (std::size_t i = 20; i + 20 < drive->imu.size(); ++i) {
    const ImuRow& row = drive->imu[i];
    const double taken = static_cast<double>(i) * period + phase;
    EXPECT_NEAR(row.t - first, static_cast<double>(i) * period, 1e-3);
    const double off = row.rate.y() / degree - shaken(taken);
    if (row.rate_missed.isZero())
      misplaced += std::abs(off) > 1e-5;
    else
      square += off * off / static_cast<double>(drive->lost);
  }
  // The place of a lost sample is known within one or two rows, so it may be swapped with a
  // neighbour.
  EXPECT_LT(misplaced, static_cast<int>(drive->imu.size() / 50));
  EXPECT_LT(std::sqrt(square), 2.5);  // the vibration is 3.6
  fs::remove_all(folder);
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
