#include <gmock/gmock.h>

#include <Eigen/LU>
#include <limits>
#include <random>

#include "tests/estimators/pipeline/reckoning_runs.hpp"

namespace drydock::pipeline::dead_reckoning_estimator_test {
namespace {

using namespace reckoning_runs;
using Eigen::Vector2d;
using testing::HasSubstr;

TEST(DeadReckoning, AStraightLegIsSpeedTimesTime) {
  Reckoning run(by_dvl());
  for (int s = 0; s <= 1000; ++s) run.take(track(1000 * s, {1.5, 0, 0}, 90 * degree));
  EXPECT_NEAR(run.offset().x(), 0, 0.2);  // the curve of the Earth: d^2 tan(latitude) / 2R
  EXPECT_NEAR(run.offset().y(), 1500, 1e-3);
  EXPECT_EQ(run.all.size(), 1001u);
  EXPECT_NEAR(run.all.back().velocity_ned.y(), 1.5, 1e-12);
  EXPECT_EQ(run.estimator.status().bridged, 0u);
}

/// A heading error of 1 degree pushes 1500 m aside by 26.2 m, a scale of half a percent along by
/// 7.5 m; the start has 10 m, a thousand samples of 2 cm/s 0.63 m and the wander 0.91 m.
TEST(DeadReckoning, ItsCovarianceIsThatOfHeadingScaleAndStart) {
  ReckoningOptions options = by_dvl();
  options.errors.heading_rad = degree;
  Reckoning run(options);
  for (int s = 0; s <= 1000; ++s) run.take(track(1000 * s, {1.5, 0, 0}, 90 * degree));
  const auto& p = run.all.back().covariance;
  const double noise = 1000 * (0.02 * 0.02 + 0.1 * 0.1 / 12);
  EXPECT_NEAR(p(0, 0), 100 + std::pow(1500 * degree, 2) + noise, 0.1);
  EXPECT_NEAR(p(1, 1), 100 + std::pow(1500 * 0.005, 2) + noise, 0.1);
}

/// 200 runs of turning legs with a drawn heading error, scale and start: the squares of the errors,
/// in units of the covariance, have the mean of chi-square with two degrees of freedom.
TEST(DeadReckoning, ItsErrorsAreAsLargeAsItSays) {
  std::mt19937 random(20);
  std::normal_distribution<double> normal;
  ReckoningOptions options = by_dvl();
  options.errors.wander = 0;
  double squares = 0;
  constexpr int runs = 200;
  for (int i = 0; i < runs; ++i) {
    Reckoning run(options);
    const double turned = options.errors.heading_rad * normal(random),
                 scale = 1 + options.errors.scale * normal(random);
    const Vector2d begun{10 * normal(random), 10 * normal(random)};
    Vector2d truth = begun, before{};
    for (int s = 0; s <= 900; ++s) {
      const double heading = s < 400 ? 0.5 : s < 700 ? 2.0 : 4.0;
      const Vector2d now = 2 * scale * Vector2d{std::cos(heading), std::sin(heading)};
      if (s > 0) truth += (before + now) / 2;
      before = now;
      const Vector3d noise{0.02 * normal(random), 0.02 * normal(random), 0};
      run.take(track(1000 * s, Vector3d{2, 0, 0} + noise, heading - turned));
    }
    const Vector2d error = run.offset().head<2>() - truth;
    squares += error.dot(run.all.back().covariance.topLeftCorner<2, 2>().inverse() * error);
  }
  EXPECT_NEAR(squares / runs, 2, 4 * 2 / std::sqrt(runs));  // four sigmas of that mean
}

TEST(DeadReckoning, PitchAndRollTurnTheVelocityIntoTheLevel) {
  Reckoning run(by_dvl());
  for (int s = 0; s <= 100; ++s) {
    auto diving = track(1000 * s, {2, 0, 0}, 0);
    diving.pitch_rad = -30 * degree;
    run.take(diving);
  }
  EXPECT_NEAR(run.offset().x(), 200 * std::sqrt(0.75), 1e-2);
  EXPECT_NEAR(run.offset().z(), 100, 1e-2);
}

/// The head is turned by 90 degrees to starboard: its roll is the vehicle's pitch, its pitch the
/// roll reversed, and its heading 90 degrees more.
TEST(DeadReckoning, TheDvlsOwnAttitudeIsThatOfItsHead) {
  ReckoningOptions options = by_dvl();
  options.dvl->sensor_to_body << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  Reckoning run(options);
  for (int s = 0; s <= 100; ++s) {
    auto diving = track(1000 * s, {2, 0, 0}, 120 * degree);
    diving.roll_rad = -30 * degree;
    run.take(diving);
  }
  EXPECT_NEAR(run.offset().head<2>().norm(), 200 * std::sqrt(0.75), 1e-2);
  EXPECT_NEAR(std::atan2(run.offset().y(), run.offset().x()), 30 * degree, 1e-5);
  EXPECT_NEAR(run.offset().z(), 100, 1e-2);
}

/// A head at 45 degrees on a vehicle whose bow is 30 degrees down. By the elementary rotations its
/// bow axis is asin(sin 30 cos 45) down, which its pitch sensor reads as more since it is heeled,
/// and points atan(tan 45 / cos 30) from the vehicle's.
TEST(DeadReckoning, AHeadBetweenBowAndStarboardTellsTheAttitudeOfTheVehicle) {
  const double pitch = -30 * degree, slant = 45 * degree;
  ReckoningOptions options = by_dvl();
  options.dvl->sensor_to_body << std::cos(slant), -std::sin(slant), 0, std::sin(slant),
      std::cos(slant), 0, 0, 0, 1;
  Reckoning run(options);
  for (int s = 0; s <= 100; ++s) {
    auto diving =
        track(1000 * s, {2, 0, 0}, 20 * degree + std::atan(std::tan(slant) / std::cos(pitch)));
    // The sensors read the tilt of an axis each: asin of its part along gravity, and the heel.
    diving.roll_rad = std::atan2(std::sin(pitch) * std::sin(slant), std::cos(pitch));
    diving.pitch_rad = std::atan2(std::sin(pitch) * std::cos(slant), std::cos(pitch));
    run.take(diving);
  }
  EXPECT_NEAR(run.offset().head<2>().norm(), 200 * std::sqrt(0.75), 1e-2);
  EXPECT_NEAR(std::atan2(run.offset().y(), run.offset().x()), 20 * degree, 1e-5);
  EXPECT_NEAR(run.offset().z(), 100, 1e-2);
}

/// A head that stands 20 degrees nose up in the vehicle and tells no tilts: the vehicle is level,
/// not the head.
TEST(DeadReckoning, WithoutTiltsTheVehicleIsTakenAsLevel) {
  ReckoningOptions options = by_dvl();
  options.dvl->sensor_to_body =
      Eigen::AngleAxisd(20 * degree, Vector3d::UnitY()).toRotationMatrix();
  Reckoning run(options);
  for (int s = 0; s <= 100; ++s) {
    auto untold = track(1000 * s, {2, 0, 0}, 40 * degree);
    untold.roll_rad.reset();
    untold.pitch_rad.reset();
    run.take(untold);
  }
  EXPECT_NEAR(run.offset().z(), 0, 1e-2);
  EXPECT_NEAR(run.offset().head<2>().norm(), 200, 1e-2);
  EXPECT_NEAR(std::atan2(run.offset().y(), run.offset().x()), 40 * degree, 1e-5);
}

TEST(DeadReckoning, ADepthSensorGivesTheDepthOfTheOrigin) {
  ReckoningOptions options = by_dvl();
  options.depth = at(depth_device, {0, 0, 0.5});
  Reckoning run(options);
  run.take(track(0, {1, 0, 0.2}, 0));
  measurement::DepthSample depth;
  depth.origin = origin(900, depth_device);
  depth.depth_m = 12.5;
  run.take(depth);
  run.take(track(1000, {1, 0, 0.2}, 0));
  EXPECT_NEAR(run.all.back().position.height_m, -12, 1e-6);
  EXPECT_NEAR(run.all.back().covariance(2, 2), 0.25, 1e-12);
}

/// Twenty seconds without bottom lock between 1 m/s and 3 m/s: 40 m, and sigma q T^3 / 12 more.
TEST(DeadReckoning, AGapIsBridgedByALineAndCounted) {
  Reckoning run(by_dvl());
  run.take(track(0, {1, 0, 0}, 0));
  for (int s = 2; s < 20; s += 2) {
    auto lost = track(1000 * s, {}, 0);
    lost.velocity.reset();
    EXPECT_EQ(run.take(lost), Outcome::unused);
  }
  const double before = run.all.back().covariance(0, 0);
  run.take(track(20'000, {3, 0, 0}, 0));
  EXPECT_NEAR(run.offset().x(), 40, 1e-3);
  EXPECT_EQ(run.estimator.status().bridged, 1u);
  EXPECT_NEAR(run.estimator.status().bridged_s, 20, 1e-9);
  EXPECT_NEAR(run.all.back().covariance(0, 0) - before,
              0.01 * 8000 / 12 + std::pow(0.02 * 20, 2) + std::pow(40 * 0.005, 2), 1e-6);
}

TEST(DeadReckoning, ASpeedWithoutAFreshHeadingIsNotUsed) {
  ReckoningOptions options = by_dvl();
  options.heading = at_origin(compass_device);
  Reckoning run(options);
  EXPECT_EQ(run.take(track(0, {1, 0, 0}, 90 * degree)), Outcome::unused);  // its compass is another
  EXPECT_EQ(run.take(compass(0, 0)), Outcome::accepted);
  EXPECT_EQ(run.take(track(1000, {1, 0, 0}, 90 * degree)), Outcome::accepted);
  EXPECT_EQ(run.take(track(9000, {1, 0, 0}, 90 * degree)), Outcome::unused);
  run.take(compass(9500, 0));
  run.take(track(10'000, {1, 0, 0}, 90 * degree));
  EXPECT_NEAR(run.offset().x(), 10, 1e-3);  // since the first measurement
  EXPECT_EQ(run.estimator.status().bridged, 1u);
}

TEST(DeadReckoning, MagneticHeadingsGetTheVariation) {
  ReckoningOptions options = by_dvl();
  options.variation_rad = -15 * degree;
  Reckoning run(options);
  for (int s = 0; s <= 100; ++s) run.take(track(1000 * s, {1, 0, 0}, 105 * degree));
  EXPECT_NEAR(run.offset().y(), 100, 1e-2);
}

/// The DVL is 5 m ahead of the origin. The vehicle turns on the spot: the origin stays.
TEST(DeadReckoning, ATurnOnTheSpotMovesTheDvlAndNotTheOrigin) {
  ReckoningOptions options = by_dvl();
  options.dvl = at(dvl_device, {5, 0, 0});
  Reckoning run(options);
  const double rate = degree;
  for (int s = 0; s <= 90; ++s) run.take(track(1000 * s, {0, 5 * rate, 0}, rate * s));
  EXPECT_LT(run.offset().head<2>().norm(), 0.01);
}

/// Two fixes 1000 m apart show that the compass is 2 degrees wrong, and the track behind is right.
TEST(DeadReckoning, FixesShowTheHeadingError) {
  ReckoningOptions options = by_dvl();
  options.gnss = at_origin(gnss_device);
  options.errors.heading_rad = 3 * degree;
  Reckoning run(options);
  const auto sail = [&](int from, int to) {
    for (int s = from; s <= to; ++s) run.take(track(1000 * s, {1, 0, 0}, 2 * degree));
  };
  sail(0, 0);
  run.take(fix(0, {0, 0, 0}, 0.1));
  sail(1, 1000);
  EXPECT_NEAR(run.offset().y(), 1000 * std::sin(2 * degree), 1);
  run.take(fix(1'000'000, {1000, 0, 0}, 0.1));
  sail(1001, 2000);
  EXPECT_NEAR(run.offset().y(), 0, 1);
  EXPECT_NEAR(run.all.back().velocity_ned.y(), 0, 1e-3);
  ASSERT_EQ(run.innovations.size(), 2u);
  // The north shows the heading a little already, so the east is compared with less of an error.
  EXPECT_NEAR(run.innovations[1].rows[0].value, 1000 * (1 - std::cos(2 * degree)), 0.1);
  EXPECT_NEAR(run.innovations[1].rows[1].value, -1000 * std::sin(2 * degree), 3);
}

TEST(DeadReckoning, WhatNoVehicleDoesIsRefusedAndThePastIsLate) {
  Reckoning run(by_dvl());
  EXPECT_EQ(run.take(track(0, {1, 0, 0}, 0)), Outcome::accepted);
  EXPECT_EQ(run.take(track(1000, {200, 0, 0}, 0)), Outcome::refused);
  EXPECT_EQ(run.take(track(1000, {std::numeric_limits<double>::quiet_NaN(), 0, 0}, 0)),
            Outcome::refused);
  EXPECT_EQ(run.take(track(-1000, {1, 0, 0}, 0)), Outcome::late);
  EXPECT_EQ(run.all.size(), 1u);
}

TEST(DeadReckoning, AClockThatIsSetBackStartsAnew) {
  Reckoning run(by_dvl());
  run.take(track(3'600'000, {1, 0, 0}, 0));
  for (int s = 0; s < 20; ++s) run.take(track(1000 * s, {1, 0, 0}, 0));
  EXPECT_EQ(run.estimator.status().restarts, 1u);
  EXPECT_NEAR(run.offset().x(), 10, 1e-3);
}

TEST(DeadReckoning, OptionsWithoutSpeedHeadingOrStartAreRefused) {
  ReckoningOptions none;
  EXPECT_THAT(fault_of(none), HasSubstr("dvl or log"));
  ReckoningOptions blind = by_dvl();
  blind.dvl.reset();
  blind.log = at_origin(log_device);
  EXPECT_THAT(fault_of(blind), HasSubstr("heading"));
  ReckoningOptions nowhere = by_dvl();
  nowhere.start.reset();
  EXPECT_THAT(fault_of(nowhere), HasSubstr("latitude_deg"));
  EXPECT_EQ(fault_of(by_dvl()), "");
}

}  // namespace
}  // namespace drydock::pipeline::dead_reckoning_estimator_test
