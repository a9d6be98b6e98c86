#include "estimators/smoothing/inertial_smoother.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <random>

#include "estimators/frame/local_earth.hpp"
#include "tests/estimators/navigation/analytic_voyage.hpp"

namespace drydock::smoothing {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using navigation::NavigationState;
using navigation::test::AnalyticVoyage;

constexpr double dive_s = 200, fixes_until_s = 20, fixes_from_s = 180;

/// A tactical-grade IMU on the analytic voyage: DVL at 1 Hz (3 cm/s), depth at 1 Hz (0.5 m), fixes
/// of 2 m at both ends. The errors are drawn from `options`.
struct InertialDive {
  std::mt19937_64 random;
  InertialOptions options;
  Dive dive;
  AnalyticVoyage voyage;

  explicit InertialDive(std::uint64_t seed) : random(seed) {
    auto& o = options.navigation;
    o.alignment_rad = {2e-3, 2e-3, 1e-2};
    o.gyro_bias_radps = 2e-5;
    o.accel_bias_mps2 = 5e-3;
    o.angle_noise_rad = 2e-5;
    o.velocity_noise_mps = 2e-4;
    options.imu_means = true;
    options.start = wrong_start();
    add_imu();
    add_readings();
  }

  double normal(double sigma) { return std::normal_distribution<double>(0, sigma)(random); }
  Vector3d normal3(double sigma) { return {normal(sigma), normal(sigma), normal(sigma)}; }

  NavigationState wrong_start() {
    const auto& o = options.navigation;
    NavigationState start = voyage.at(0);
    const auto earth = frame::local_earth(start.position.latitude_rad, 0);
    start.position.latitude_rad += normal(o.position_m) / earth.meridian_radius_m;
    start.position.longitude_rad +=
        normal(o.position_m) / (earth.transverse_radius_m * earth.cos_latitude);
    start.position.height_m += normal(o.height_m);
    start.velocity_ned += normal3(o.velocity_mps);
    start.body_to_ned =
        navigation::quaternion_of(-normal3(1).cwiseProduct(o.alignment_rad)) * start.body_to_ned;
    return start;
  }

  void add_imu() {
    constexpr double dt = 0.02;
    const auto& o = options.navigation;
    const Vector3d gyro = normal3(o.gyro_bias_radps), accel = normal3(o.accel_bias_mps2);
    dive.inertial.push_back({});
    for (int k = 1; k * dt <= dive_s + dt / 2; ++k) {
      const auto sample = voyage.sample((k - 1) * dt, dt);
      dive.inertial.push_back(
          {k * dt, sample.angle / dt + gyro + normal3(o.angle_noise_rad / std::sqrt(dt)),
           sample.velocity / dt + accel + normal3(o.velocity_noise_mps / std::sqrt(dt))});
    }
  }

  void add_readings() {
    for (int t = 1; t <= dive_s; ++t) {
      const NavigationState truth = voyage.at(t);
      const auto& at = truth.position;
      const auto earth = frame::local_earth(at.latitude_rad, at.height_m);
      dive.readings.push_back({double(t), Quantity::bottom, 0,
                               truth.body_to_ned.conjugate() * truth.velocity_ned + normal3(0.03),
                               Vector3d::Constant(0.03)});
      dive.readings.push_back({double(t),
                               Quantity::depth,
                               1,
                               {-at.height_m + normal(0.5), 0, 0},
                               Vector3d::Constant(0.5)});
      if (t > fixes_until_s && t < fixes_from_s) continue;
      dive.readings.push_back(
          {double(t),
           Quantity::fix,
           2,
           {at.latitude_rad + normal(2) / (earth.meridian_radius_m + at.height_m),
            at.longitude_rad +
                normal(2) / ((earth.transverse_radius_m + at.height_m) * earth.cos_latitude),
            0},
           Vector3d::Constant(2)});
    }
  }
};

Vector2d error_of(const TrackPoint& point, const AnalyticVoyage& voyage) {
  return frame::ned_offset(voyage.at(point.time_s).position, point.position).head<2>();
}

TEST(InertialSmoother, ItsErrorsAreAsLargeAsItsCovarianceSaysAndHalfOfTheFilters) {
  // Two axes of 240 dives, each with points that hang together: the mean is within 1 +- 0.07 in two
  // of three such tests, or better, since they hang together only in part.
  double nees = 0, smoother = 0, filter = 0;
  int count = 0;
  for (std::uint64_t run = 0; run < 240; ++run) {
    const InertialDive dive(1000 + run);
    const Track track = smooth_inertial(dive.dive, dive.options);
    for (std::size_t k = 0; k < track.smoothed.size(); k += 300) {
      const auto& point = track.smoothed[k];
      if (point.time_s < fixes_until_s || point.time_s > fixes_from_s) continue;
      const Vector2d error = error_of(point, dive.voyage);
      const Matrix2d p = point.position_covariance.topLeftCorner<2, 2>();
      nees += error.dot(p.inverse() * error) / 2;
      smoother += error.squaredNorm();
      filter += error_of(track.filtered[k], dive.voyage).squaredNorm();
      ++count;
    }
  }
  EXPECT_GT(count, 240 * 4);
  EXPECT_NEAR(nees / count, 1, 0.1);
  EXPECT_LT(std::sqrt(smoother / count), 0.5 * std::sqrt(filter / count));
}

TEST(InertialSmoother, NoEpochIsLessCertainThanTheFilters) {
  const InertialDive dive(1);
  const Track track = smooth_inertial(dive.dive, dive.options);
  ASSERT_GT(track.smoothed.size(), 1990U);
  double least = 1;
  for (std::size_t k = 0; k < track.smoothed.size(); ++k) {
    const Eigen::Matrix3d gained =
        track.filtered[k].position_covariance - track.smoothed[k].position_covariance;
    least = std::min(least, gained.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff());
  }
  EXPECT_GT(least, -1e-6);
}

TEST(InertialSmoother, ComparesEveryReadingButLogs) {
  InertialDive dive(2);
  dive.dive.readings.push_back({dive_s, Quantity::log, 4, {1, 0, 0}, {1, 1, 1}});
  const Track track = smooth_inertial(dive.dive, dive.options);
  EXPECT_TRUE(track.residuals.front()[0].known);
  EXPECT_FALSE(track.residuals.back()[0].known);
}

}  // namespace
}  // namespace drydock::smoothing
