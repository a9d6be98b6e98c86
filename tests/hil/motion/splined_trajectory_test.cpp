#include "hil/motion/splined/splined_trajectory.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "estimators/frame/attitude.hpp"
#include "hil/motion/bad_mission.hpp"
#include "hil/motion/kinematic_trajectory.hpp"
#include "tests/hil/motion/mechanization.hpp"
#include "tests/hil/motion/missions.hpp"

namespace drydock::motion {
namespace {

using Eigen::Vector3d;

using Scalar = Eigen::Matrix<double, 1, 1>;
constexpr double pi = std::numbers::pi;

/// Knots that are not equally spaced.
std::vector<double> uneven_knots() { return {0, 0.7, 1, 2.5, 2.6, 4, 5.5, 6}; }

RC_GTEST_PROP(CubicSpline, IsEveryCubicThatItGoesThrough, ()) {
  const auto coefficient = [] { return *rc::gen::inRange(-1000, 1000) / 100.0; };
  const double a = coefficient(), b = coefficient(), c = coefficient(), d = coefficient();
  const auto value = [&](double t) { return a + t * (b + t * (c + t * d)); };
  std::vector<Scalar> values;
  for (const double t : uneven_knots()) values.emplace_back(value(t));
  const CubicSpline<1> spline(uneven_knots(), values);
  for (double t = -0.5; t < 7; t += 0.31) {
    const auto point = spline.at(t);
    RC_ASSERT(std::abs(point.value[0] - value(t)) < 1e-8);
    RC_ASSERT(std::abs(point.rate[0] - (b + t * (2 * c + 3 * t * d))) < 1e-8);
    RC_ASSERT(std::abs(point.acceleration[0] - (2 * c + 6 * t * d)) < 1e-7);
  }
}

TEST(CubicSpline, IsALineThroughTwoPointsAndAParabolaThroughThree) {
  const CubicSpline<1> line({1, 3}, {Scalar(2.0), Scalar(6.0)});
  EXPECT_DOUBLE_EQ(line.at(2).value[0], 4);
  EXPECT_DOUBLE_EQ(line.at(2).rate[0], 2);
  const CubicSpline<1> parabola({0, 1, 4}, {Scalar(0.0), Scalar(1.0), Scalar(16.0)});
  EXPECT_NEAR(parabola.at(3).value[0], 9, 1e-12);
  EXPECT_NEAR(parabola.at(0.5).acceleration[0], 2, 1e-12);
}

TEST(CubicSpline, HasNoStepInItsAccelerationAtAnyKnot) {
  std::vector<Scalar> values;
  for (const double y : {0.0, 1.0, -2.0, 5.0, 0.5, -1.0, 3.0, 2.0}) values.emplace_back(y);
  const CubicSpline<1> spline(uneven_knots(), values);
  for (const double knot : uneven_knots()) {
    const auto before = spline.at(std::nextafter(knot, -1)), behind = spline.at(knot);
    EXPECT_NEAR(before.value[0], behind.value[0], 1e-12);
    EXPECT_NEAR(before.rate[0], behind.rate[0], 1e-10);
    EXPECT_NEAR(before.acceleration[0], behind.acceleration[0], 1e-9);
  }
}

/// The largest error of the acceleration on a unit circle at 1 rad/s, between two angles.
double worst_on_circle(double h, double from, double to) {
  std::vector<double> knots;
  std::vector<Eigen::Vector2d> values;
  for (int k = 0; k * h <= 2 * pi; ++k) {
    knots.push_back(k * h);
    values.emplace_back(std::cos(k * h), std::sin(k * h));
  }
  const CubicSpline<2> spline(knots, values);
  double worst = 0;
  for (double t = from; t < to; t += h / 7)
    worst = std::max(
        worst, (spline.at(t).acceleration + Eigen::Vector2d(std::cos(t), std::sin(t))).norm());
  return worst;
}

// Hall and Meyer (J. Approximation Theory 16, 1976): |s'' - f''| <= 3/8 h^2 max |f''''| inside. The
// fourth derivative of a unit circle at 1 rad/s is 1.
TEST(CubicSpline, HasTheAccelerationOfACircleWithinHSquared) {
  for (const double h : {0.2, 0.1, 0.05}) EXPECT_LT(worst_on_circle(h, 1.5, 4.5), 0.375 * h * h);
  for (const double h : {0.1, 0.05}) {
    const double ratio = worst_on_circle(2 * h, 0, 6) / worst_on_circle(h, 0, 6);
    EXPECT_NEAR(ratio, 4, 0.6) << "up to the ends";
  }
}

/// A dive with turns, on a grid of poses.
Poses poses_of(const Trajectory& motion, double every_s, double duration_s) {
  Poses poses;
  for (double t = 0; t <= duration_s + 1e-9; t += every_s) {
    const auto truth = motion.at(start + measurement::from_seconds(t));
    poses.push_back(
        {t, {truth.latitude_rad, truth.longitude_rad, truth.height_m}, truth.body_to_ned});
  }
  return poses;
}

rig_config::MissionConfig turning() {
  rig_config::MissionConfig mission;
  mission.latitude_rad = 36 * degree;
  mission.longitude_rad = 129 * degree;
  mission.depth_m = 5;
  mission.speed_mps = 3;
  mission.legs = {
      {.kind = rig_config::LegKind::s_path,
       .duration_s = 60,
       .speed_mps = 3,
       .amplitude_rad = 45 * degree,
       .period_s = 30},
      {.kind = rig_config::LegKind::dive, .duration_s = 40, .depth_change_m = 8, .speed_mps = 3}};
  return mission;
}

const ocean::Ocean& still_water() {
  static const ocean::Ocean still({}, {});
  return still;
}

TEST(SplinedTrajectory, AnIndependentMechanizationOfItsImuFindsItAgain) {
  const KinematicTrajectory motion(turning(), start);
  const SplinedTrajectory splined(poses_of(motion, 1, 100), still_water(), start);
  const auto error = mechanize(splined, start, 99, 0.01);
  EXPECT_LT(error.position_m, 0.01);
  EXPECT_LT(error.velocity_mps, 1e-4);
  EXPECT_LT(error.attitude_rad, 1e-6);
}

/// The largest differences of a splined motion from the motion that its poses are of.
struct Differences {
  double velocity_mps = 0, force_mps2 = 0, rate_radps = 0;
};

Differences differences(double every_s) {
  const KinematicTrajectory motion(turning(), start);
  const SplinedTrajectory splined(poses_of(motion, every_s, 100), still_water(), start);
  Differences worst;
  for (double t = 5; t < 95; t += 0.13) {
    const auto a = motion.at(start + measurement::from_seconds(t));
    const auto b = splined.at(start + measurement::from_seconds(t));
    worst.velocity_mps = std::max(worst.velocity_mps, (a.velocity_ned - b.velocity_ned).norm());
    worst.force_mps2 = std::max(worst.force_mps2, (a.specific_force - b.specific_force).norm());
    worst.rate_radps = std::max(worst.rate_radps, (a.angular_rate - b.angular_rate).norm());
  }
  return worst;
}

TEST(SplinedTrajectory, IsTheMotionThatItsPosesAreOfWithinThePowersOfTheStep) {
  const auto coarse = differences(2), fine = differences(1);
  EXPECT_LT(fine.velocity_mps, coarse.velocity_mps / 5);  // h^3: 8
  EXPECT_LT(fine.force_mps2, coarse.force_mps2 / 2.8);    // h^2: 4
  EXPECT_LT(fine.rate_radps, coarse.rate_radps / 5);      // h^3: 8
  EXPECT_LT(fine.velocity_mps, 0.002);
  EXPECT_LT(fine.force_mps2, 0.02);
}

TEST(SplinedTrajectory, TurnsAtTheRateOfACircleWhateverTheSignsOfItsQuaternions) {
  Poses poses;
  for (int k = 0; k <= 40; ++k) {  // a yaw rate of 0.1 rad/s, twice around
    auto q = frame::body_to_ned({0, 0, frame::wrap_pi(0.1 * 3 * k)});
    if (k % 2 == 0) q.coeffs() = -q.coeffs();
    poses.push_back({3.0 * k, {0.6, 2, -5}, q});
  }
  const SplinedTrajectory splined(poses, still_water(), start);
  const auto truth = splined.at(start + measurement::from_seconds(61.3));
  EXPECT_NEAR(truth.rate_body.z(), 0.1, 5e-5);
  EXPECT_NEAR(truth.rate_body.head<2>().norm(), 0, 1e-12);
  EXPECT_NEAR(truth.angular_acceleration->z(), 0, 2e-4);
  EXPECT_NEAR(truth.yaw_rad, frame::wrap_pi(6.13), 1e-5);
}

TEST(SplinedTrajectory, GoesOnOverTheDateLine) {
  Poses poses;
  for (int k = -5; k <= 5; ++k)
    poses.push_back(
        {5.0 + k, {0, frame::wrap_pi(pi + 1e-6 * k), 0}, Eigen::Quaterniond(1, 0, 0, 0)});
  const SplinedTrajectory splined(poses, still_water(), start);
  const auto truth = splined.at(start + measurement::from_seconds(4.9));
  EXPECT_NEAR(truth.velocity_ned.y(), 6'378'137 * 1e-6, 1e-6);  // the equator's radius in WGS-84
  EXPECT_GT(truth.longitude_rad, 3.14);
}

TEST(SplinedTrajectory, ComesOnStraightBeforeAndLiesStillBehind) {
  const KinematicTrajectory motion(turning(), start);
  const SplinedTrajectory splined(poses_of(motion, 1, 50), still_water(), start);
  const auto first = splined.at(start), before = splined.at(start - std::chrono::seconds{1});
  EXPECT_NEAR((before.velocity_ned - first.velocity_ned).norm(), 0, 1e-5);
  const auto after = splined.at(splined.end() + std::chrono::seconds{1});
  EXPECT_EQ(after.velocity_ned.norm(), 0);
  EXPECT_EQ(after.latitude_rad, splined.at(splined.end()).latitude_rad);
}

TEST(SplinedTrajectory, RefusesAWayThroughTheBed) {
  const KinematicTrajectory motion(turning(), start);
  rig_config::OceanConfig shallow;
  shallow.bed.depth_m = 6;
  EXPECT_THROW(SplinedTrajectory(poses_of(motion, 1, 100), ocean::Ocean(shallow, {}), start),
               BadMission);
}

}  // namespace
}  // namespace drydock::motion
