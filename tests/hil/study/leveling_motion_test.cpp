#include "hil/study/leveling/leveling_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "estimators/frame/earth.hpp"
#include "hil/study/leveling/leveling_trial.hpp"

namespace drydock::study {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
constexpr double degree = std::numbers::pi / 180;

constexpr double latitude = 36 * degree, dt = 0.01;

Matrix3d to_ned(const LevelingMotion& motion, double t) {
  return frame::ned_to_body(motion.attitude(t)).transpose();
}

/// The expected accelerometer and gyro values, only from positions of the axes and of the vehicle:
/// differences of the velocity over ground and of the attitude, in NED on a rotating Earth.
struct FromDifferences {
  Vector3d specific_force, angular_rate;
};

FromDifferences differences(const LevelingMotion& motion, double t) {
  const double h = 1e-4;
  const auto over_ground = [&](double at) -> Vector3d {
    return to_ned(motion, at) * motion.velocity(at);
  };
  const Vector3d earth = frame::earth_rate_ned(latitude);
  const Vector3d acceleration = (over_ground(t + h) - over_ground(t - h)) / (2 * h);
  const Vector3d force_ned =
      acceleration + 2 * earth.cross(over_ground(t)) - Vector3d{0, 0, frame::gravity(latitude)};
  const Matrix3d to_body = to_ned(motion, t).transpose();
  const Matrix3d turn = to_body * (to_ned(motion, t + h) - to_ned(motion, t - h)) / (2 * h);
  return {to_body * force_ned, Vector3d{turn(2, 1), turn(0, 2), turn(1, 0)} + to_body * earth};
}

TEST(LevelingMotion, PerfectSensorsFeelWhatTheMotionDemands) {
  for (const auto& motion : {leveling_motions::stationary, leveling_motions::straight,
                             leveling_motions::s_path, leveling_motions::rolling_s_path}) {
    for (double t = 0; t < 30; t += 1.7) {
      const auto reading = motion.reading(t, dt, latitude);
      const auto expected = differences(motion, t + dt / 2);
      EXPECT_LT((reading.specific_force - expected.specific_force).norm(), 1e-6) << t;
      EXPECT_LT((reading.angular_rate - expected.angular_rate).norm(), 1e-8) << t;
      EXPECT_DOUBLE_EQ(reading.speed_mps, motion.velocity(t + dt).x());
    }
  }
}

TEST(LevelingMotion, TheRollingPathReachesItsAmplitudes) {
  double roll = 0, slip = 0, slowest = 100, fastest = 0;
  for (double t = 0; t < 30; t += 0.01) {
    const auto& motion = leveling_motions::rolling_s_path;
    roll = std::max(roll, motion.attitude(t).roll / degree);
    slip = std::max(slip, std::abs(motion.velocity(t).y()));
    slowest = std::min(slowest, motion.velocity(t).x());
    fastest = std::max(fastest, motion.velocity(t).x());
  }
  EXPECT_NEAR(roll, 10, 0.01);
  EXPECT_NEAR(slip, 2.5 * 45 * degree * 2 * std::numbers::pi / 30, 1e-3);
  EXPECT_NEAR(slowest, 8, 0.01);
  EXPECT_NEAR(fastest, 12, 0.01);
}

/// Readings with errors minus readings without: the errors of Table 1.
std::vector<Vector3d> gyro_errors_degph(LevelingBiases biases, std::size_t run) {
  const LevelingTrial trial{leveling_motions::straight, false, biases, 1, run};
  std::vector<Vector3d> errors;
  std::size_t i = 0;
  for (const auto& reading : leveling_readings(trial)) {
    const auto ideal =
        trial.motion.reading(static_cast<double>(i++) * dt, dt, leveling_latitude_rad);
    errors.push_back((reading.angular_rate - ideal.angular_rate) / (degree / 3600));
  }
  return errors;
}

TEST(LevelingReadings, HaveTheErrorsOfTable1) {
  const auto errors = gyro_errors_degph(LevelingBiases::one_sigma, 0);
  ASSERT_EQ(errors.size(), 3000U);
  Vector3d mean = Vector3d::Zero(), squares = Vector3d::Zero();
  for (const auto& e : errors) mean += e / 3000;
  for (const auto& e : errors) squares += (e - mean).cwiseAbs2() / 3000;
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(mean(axis), 1, 4 * 0.3 / std::sqrt(3000));
    EXPECT_NEAR(std::sqrt(squares(axis)), 0.3, 4 * 0.3 / std::sqrt(6000));
  }
}

TEST(LevelingReadings, DrawnBiasesAreConstantOverARunAndDifferBetweenRuns) {
  double sum = 0, sum_squares = 0;
  constexpr std::size_t runs = 40;
  for (std::size_t run = 0; run < runs; ++run) {
    const auto with = gyro_errors_degph(LevelingBiases::drawn, run);
    const auto without = gyro_errors_degph(LevelingBiases::none, run);  // the same noise
    const Vector3d bias = with.front() - without.front();
    EXPECT_LT((with.back() - without.back() - bias).norm(), 1e-9);
    sum += bias.sum();
    sum_squares += bias.squaredNorm();
  }
  EXPECT_NEAR(sum / (3 * runs), 0, 4 / std::sqrt(3.0 * runs));
  EXPECT_NEAR(sum_squares / (3 * runs), 1, 4 * std::sqrt(2 / (3.0 * runs)));
}

}  // namespace
}  // namespace drydock::study
