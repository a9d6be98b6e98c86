// The recordings of other people, smoothed: what lies ahead helps as much as it should.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cstdio>

#include "estimators/frame/geodetic.hpp"
#include "estimators/smoothing/inertial_smoother.hpp"
#include "tests/estimators/navigation/recordings/at_hand.hpp"
#include "tests/estimators/navigation/recordings/vehicles.hpp"

namespace drydock::navigation::smoothed_recordings_test {
namespace {

using namespace navigation::test;
using Eigen::Vector2d;
using Eigen::Vector3d;
using smoothing::Quantity;

constexpr std::uint16_t gnss = 0, dvl = 0, pressure = 1;

/// The point at which a track is nearest to a time.
const smoothing::TrackPoint& at(const std::vector<smoothing::TrackPoint>& points, double time_s) {
  auto next = std::ranges::lower_bound(points, time_s, {}, &smoothing::TrackPoint::time_s);
  if (next == points.end() ||
      (next != points.begin() && next->time_s - time_s > time_s - std::prev(next)->time_s))
    --next;
  return *next;
}

/// Errors in the gaps: metres, horizontal, and normalised by the covariance, per axis.
struct Errors {
  double square = 0, worst = 0, nees = 0;
  int count = 0;

  void add(const Vector2d& error, const Eigen::Matrix2d& covariance) {
    square += error.squaredNorm();
    worst = std::max(worst, error.norm());
    nees += error.dot(covariance.inverse() * error) / 2;
    ++count;
  }
  double rms() const { return std::sqrt(square / count); }
  double mean_nees() const { return nees / count; }
};

/// Of the last `gap_s` of each minute the car's fixes are kept from the smoother. They are the
/// truth.
TEST(SmoothedDrive, FixesOnBothSidesOfAGapHalveItsErrorAtLeast) {
  constexpr double every_s = 60, gap_s = 15;
  const auto folder = ins() / "rtklibexplorer_GNSS_IMU/drive_0708";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "corpora absent: " << folder;
  const auto drive = read_drive(folder);
  ASSERT_TRUE(drive.has_value()) << drive.error().line;
  const DriveSetup setup = car();
  const auto start = aligned(*drive, setup);
  ASSERT_TRUE(start.has_value()) << start.error().line;

  smoothing::Dive dive;
  for (const auto& row : start->imu) dive.inertial.push_back({row.t, row.rate, row.force});
  const double begin = drive->fixes[start->fix].t;
  const auto in_gap = [&](double t) {
    return std::fmod(t - begin, every_s) > every_s - gap_s && t - begin > every_s - gap_s;
  };
  std::vector<RtkFix> hidden;
  for (std::size_t i = start->fix + 1; i < drive->fixes.size(); ++i) {
    const RtkFix& fix = drive->fixes[i];
    if (fix.quality != 1) continue;
    if (in_gap(fix.t)) {
      hidden.push_back(fix);
      continue;
    }
    const Vector3d sigma =
        (fix.sigma_m.array().square() + setup.fix_sigma_m * setup.fix_sigma_m).sqrt();
    const auto& p = fix.position;
    dive.readings.push_back(
        {fix.t, Quantity::fix, gnss, {p.latitude_rad, p.longitude_rad, p.height_m}, sigma});
    dive.readings.push_back(
        {fix.t, Quantity::depth, gnss, {-p.height_m, 0, 0}, Vector3d::Constant(sigma.z())});
  }
  const auto track = smoothing::smooth_inertial(
      dive, {start->state, setup.options, true, Vector3d::Zero(), {setup.antenna}, 0});

  Errors filtered, smoothed;
  for (const RtkFix& fix : hidden) {
    for (auto [points, errors] :
         {std::pair(&track.filtered, &filtered), {&track.smoothed, &smoothed}}) {
      const auto& point = at(*points, fix.t);
      if (std::abs(point.time_s - fix.t) > 0.2) continue;
      const Vector3d moved = point.velocity_ned * (fix.t - point.time_s);
      const Vector3d antenna = frame::body_to_ned(point.attitude) * setup.antenna;
      errors->add((frame::ned_offset(fix.position, point.position) + moved + antenna).head<2>(),
                  point.position_covariance.topLeftCorner<2, 2>());
    }
  }
  std::printf(
      "| drive_0708, %d fixes in gaps | filter %.2f m RMS, %.2f worst, NEES %.2f | smoother "
      "%.2f, %.2f, %.2f |\n",
      filtered.count, filtered.rms(), filtered.worst, filtered.mean_nees(), smoothed.rms(),
      smoothed.worst, smoothed.mean_nees());
  EXPECT_GT(smoothed.count, 8 * 50);
  EXPECT_LT(smoothed.rms(), 0.5 * filtered.rms());
  EXPECT_LT(smoothed.worst, 1);
  EXPECT_GT(smoothed.mean_nees(), 0.3);
  EXPECT_LT(smoothed.mean_nees(), 3);  // it does not know which samples the logger lost
}

smoothing::Dive dive_of(const PoolRecording& pool, const DiveSetup& setup,
                        const AlignedDive& start) {
  smoothing::Dive dive;
  for (std::size_t i = start.sample - 1; i < pool.imu.size(); ++i)
    dive.inertial.push_back({pool.imu[i].t, setup.imu_to_body * pool.imu[i].rate,
                             setup.imu_to_body * pool.imu[i].force});
  for (std::size_t i = start.ping; i < pool.dvl.size(); ++i)
    dive.readings.push_back({pool.dvl[i].t, Quantity::bottom, dvl,
                             setup.dvl_to_body * pool.dvl[i].value,
                             Vector3d::Constant(setup.dvl_sigma_mps)});
  for (std::size_t i = start.pressed; i < pool.pressure.size(); ++i)
    dive.readings.push_back({pool.pressure[i].t,
                             Quantity::depth,
                             pressure,
                             {-height_of(pool.pressure[i], setup), 0, 0},
                             Vector3d::Constant(setup.depth_sigma_m)});
  std::ranges::stable_sort(dive.readings, {}, &smoothing::Reading::time_s);
  return dive;
}

/// The DVL of the ten seconds amid the dive is kept from the smoother. What it saw is the truth.
TEST(SmoothedDives, InAPoolAHeadThatLostTheBottomForTenSecondsIsBridgedBetterThanByTheFilter) {
  if (!std::filesystem::exists(ins() / "sonia_pool")) GTEST_SKIP() << "corpora absent: " << ins();
  for (const auto& run : std::filesystem::directory_iterator{ins() / "sonia_pool"}) {
    SCOPED_TRACE(run.path());
    const auto pool = read_pool(run.path());
    ASSERT_TRUE(pool.has_value()) << pool.error().line;
    const DiveSetup setup = sonia();
    const auto start = aligned(*pool, setup);
    ASSERT_TRUE(start.has_value()) << start.error().line;
    auto dive = dive_of(*pool, setup, *start);
    const double middle = (start->begin_s + pool->imu.back().t) / 2;
    std::vector<smoothing::Reading> hidden;
    std::erase_if(dive.readings, [&](const smoothing::Reading& reading) {
      if (reading.quantity != Quantity::bottom || std::abs(reading.time_s - middle) > 5)
        return false;
      hidden.push_back(reading);
      return true;
    });
    const auto track = smoothing::smooth_inertial(dive, {start->state,
                                                         setup.options,
                                                         true,
                                                         Vector3d::Zero(),
                                                         {setup.dvl_lever, setup.pressure_lever},
                                                         0});
    const auto rms_mps = [&](const std::vector<smoothing::TrackPoint>& points) {
      double square = 0;
      for (const auto& seen : hidden) {
        const auto& point = at(points, seen.time_s);
        square += (frame::body_to_ned(point.attitude).conjugate() * point.velocity_ned - seen.value)
                      .squaredNorm();
      }
      return std::sqrt(square / static_cast<double>(hidden.size()));
    };
    const double filter = rms_mps(track.filtered), smoother = rms_mps(track.smoothed);
    std::printf("| %s | %zu velocities hidden | filter %.3f m/s RMS | smoother %.3f |\n",
                run.path().filename().c_str(), hidden.size(), filter, smoother);
    EXPECT_GT(hidden.size(), 20U);
    EXPECT_LT(smoother, 0.9 * filter);
  }
}

}  // namespace
}  // namespace drydock::navigation::smoothed_recordings_test
