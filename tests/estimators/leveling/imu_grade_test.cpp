#include "estimators/leveling/imu_grade.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "estimators/leveling/any_leveling_filter.hpp"
#include "tests/estimators/leveling/s_path.hpp"

namespace drydock::leveling {
namespace imu_grade_test {
namespace {

using test::degree;
using test::dt;

/// An MTi-630: .42 deg/sqrt(h) of angle random walk, 8 deg/h that wander within 600 s, .87 mrad of
/// misalignment (docs/sensors/errors.md).
constexpr double walk = 0.42 * degree / 60, wander = 8 * degree / 3600, wander_s = 600,
                 turned = 0.87e-3;
constexpr ImuGrade mti{.angle_noise_rad = walk,
                       .velocity_noise_mps = 60e-6 * 9.80665,
                       .gyro_bias_radps = wander,
                       .accelerometer_bias_mps2 = turned * 9.80665,
                       .gyro_bias_walk_radps = 0.0577 * wander,  // sqrt(2 / 600)
                       .rate_share = turned};

/// Mean normalised square of roll and pitch, per state, of five minutes from the second on.
double nees(const ImuGrade& grade, FilterKind kind, const test::SPath& path) {
  double sum = 0;
  long count = 0;
  for (unsigned run = 0; run < 4; ++run) {
    auto options = worsened(options_for(kind), kind, grade);
    options.latitude_rad = test::latitude;
    std::visit(
        [&](auto&& filter) {
          test::Table1Sensors sensors{70 + run};
          std::mt19937_64 engine{run};
          std::normal_distribution<double> normal;
          const auto white = [&] {
            const double x = normal(engine), y = normal(engine), z = normal(engine);
            return Eigen::Vector3d{x, y, z};
          };
          Eigen::Vector3d bias = wander * white();
          const Eigen::Vector3d tilt = turned * white(), skewed = turned * white();
          for (long k = 0; k < 30'000; ++k) {
            const auto truth = path.at(static_cast<double>(k) * dt);
            auto r = sensors(truth);
            bias += -bias * dt / wander_s + wander * std::sqrt(2 * dt / wander_s) * white();
            r.angular_rate +=
                bias + skewed.cross(truth.angular_rate) + walk / std::sqrt(dt) * white();
            r.specific_force += tilt.cross(truth.specific_force);
            if (k == 0) {
              filter.start(r.specific_force, r.angular_rate, r.speed);
              continue;
            }
            filter.predict(r.specific_force, r.angular_rate, dt);
            filter.update_nonholonomic(dt);
            if (k % 50 == 0) filter.update_moving(r.speed);
            if (k < 6000) continue;
            const Eigen::Vector2d error{filter.roll(), filter.pitch()};
            sum += error.dot(filter.roll_pitch_covariance().inverse() * error) / 2;
            ++count;
          }
        },
        make_filter(kind, options));
  }
  return sum / static_cast<double>(count);
}

TEST(ImuGrade, KeepsTheCovarianceTrueForAnImuThatIsWorseThanThatOfThePaper) {
  test::SPath straight;
  straight.speed = 1.8;
  straight.amplitude = 0;
  test::SPath weaving = straight;
  weaving.amplitude = 45 * degree;
  for (const auto& path : {straight, weaving}) {
    EXPECT_GT(nees({}, FilterKind::augmented, path), 2) << "as if it were that of the paper";
    const double known = nees(mti, FilterKind::augmented, path);
    EXPECT_LT(known, 2);
    EXPECT_GT(known, 0.2);
  }
  test::SPath circling = straight;  // a slow sine of the heading, .1 rad/s over these minutes
  circling.period = 4000;
  circling.amplitude = 0.1 * circling.period / (2 * std::numbers::pi);
  EXPECT_LT(nees(mti, FilterKind::augmented, circling), 2);
}

TEST(ImuGrade, OfABetterImuChangesNothing) {
  const auto usual = options_for(FilterKind::augmented);
  const auto options =
      worsened(usual, FilterKind::augmented, {.angle_noise_rad = 1e-9, .gyro_bias_radps = 1e-9});
  EXPECT_EQ(options.alpha_noise, usual.alpha_noise);
  EXPECT_EQ(options.velocity_noise, usual.velocity_noise);
  EXPECT_EQ(options.gyro_bias_sigma_radps, usual.gyro_bias_sigma_radps);
}

// Without bias states the noise of alpha covers the bias: 1e-5 for 1 deg/h.
TEST(ImuGrade, CoversTheBiasOfAWorseGyroWithNoiseWhereThereAreNoBiasStates) {
  const auto options = worsened(options_for(FilterKind::robust), FilterKind::robust,
                                {.gyro_bias_radps = 10 * degree / 3600});
  EXPECT_NEAR(options.alpha_noise, 1e-4, 1e-9);
}

}  // namespace
}  // namespace imu_grade_test
}  // namespace drydock::leveling
