// Errors of tracks whose errors are known: circles and lines, shifted and turned.
#include "hil/score/errors.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "hil/score/align.hpp"
#include "hil/score/attitude.hpp"

namespace drydock::score {
namespace errors_test {

using Eigen::Vector3d;
using std::chrono::milliseconds;

constexpr double degree = std::numbers::pi / 180;
constexpr std::chrono::nanoseconds any_gap = std::chrono::hours{1};

measurement::Stamp at(double t_s) { return measurement::Stamp{measurement::from_seconds(t_s)}; }

Eigen::Quaterniond heading(double angle) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vector3d::UnitZ()));
}

/// Of the circle.
Vector3d way_mps(double angle) {
  return {-100 * degree * std::sin(angle), 100 * degree * std::cos(angle), 0.1};
}

/// A circle of 100 m around (0, 0) at 1 degree a second, the bow along the way, diving 0.1 m/s.
Track circle(double seconds = 200) {
  Track track;
  for (double t = 0; t <= seconds; t += 0.5) {
    const double angle = t * degree;
    track.push_back({.at = at(t),
                     .position_ned = {100 * std::cos(angle), 100 * std::sin(angle), 0.1 * t},
                     .angles = {0, 0, angle + std::numbers::pi / 2},
                     .velocity = way_mps(angle)});
  }
  return track;
}

Track moved(Track track, const Eigen::Quaterniond& turn, const Vector3d& shift) {
  for (State& state : track) {
    state.position_ned = turn * state.position_ned + shift;
    state.angles = angles_of(turn * *attitude_of(state));
    state.velocity = turn * state.velocity;
  }
  return track;
}

Errors compared(const Track& estimates, Alignment alignment) {
  auto pairs = pairs_of(estimates, circle(), any_gap);
  align(pairs.all, alignment);
  return errors_of(pairs.all, std::chrono::seconds{10});
}

TEST(Score, AShiftIsTheErrorOfEveryPose) {
  const auto errors = compared(moved(circle(), heading(0), {3, 4, 12}), Alignment::none);
  EXPECT_EQ(errors.pairs, 401U);
  EXPECT_NEAR(errors.ate_m->rms, 13, 1e-9);
  EXPECT_NEAR(errors.ate_m->mean, 13, 1e-9);
  EXPECT_NEAR(errors.ate_m->max, 13, 1e-9);
  EXPECT_NEAR(*errors.horizontal_rms_m, 5, 1e-9);
  EXPECT_NEAR(*errors.vertical_rms_m, 12, 1e-9);
  EXPECT_NEAR(*errors.end_m, 13, 1e-9);
  EXPECT_NEAR(errors.attitude_deg->rms, 0, 1e-6);
  EXPECT_NEAR(errors.rpe_m->rms, 0, 1e-9) << "a shift is no error of the way";
  EXPECT_FALSE(errors.position_nees.mean);
}

TEST(Score, StartYawAndRigidEachTakeAwayWhatTheyMay) {
  const auto shifted = moved(circle(), heading(0), {3, 4, 12});
  const auto turned = moved(circle(), heading(30 * degree), {3, 4, 12});
  const auto tilted =
      moved(circle(), Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Vector3d{1, 2, 3}.normalized())),
            {1, 1, 1});
  EXPECT_NEAR(compared(shifted, Alignment::start).ate_m->max, 0, 1e-9);
  EXPECT_GT(compared(turned, Alignment::start).ate_m->max, 50);
  EXPECT_NEAR(compared(turned, Alignment::yaw).ate_m->max, 0, 1e-8);
  EXPECT_NEAR(compared(turned, Alignment::yaw).attitude_deg->max, 0, 1e-5);
  EXPECT_GT(compared(tilted, Alignment::yaw).ate_m->max, 5);
  EXPECT_NEAR(compared(tilted, Alignment::rigid).ate_m->max, 0, 1e-8);
}

TEST(Score, ATurnAboutTheCentreIsAChordAndItsAngle) {
  const auto errors = compared(moved(circle(), heading(10 * degree), {0, 0, 0}), Alignment::none);
  EXPECT_NEAR(errors.ate_m->rms, 2 * 100 * std::sin(5 * degree), 1e-9);
  EXPECT_NEAR(errors.attitude_deg->rms, 10, 1e-6);
  EXPECT_NEAR(errors.rpe_m->rms, 0, 1e-9) << "in the body's axes the way is the same";
  EXPECT_NEAR(errors.rpe_deg->rms, 0, 1e-5);
}

TEST(Score, AScaleOfTheWayIsARelativeError) {
  Track estimates = circle(), truth = circle();
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double t = 0.5 * static_cast<double>(i);
    truth[i].position_ned = {2 * t, 0, 0};
    estimates[i].position_ned = {2.02 * t, 0, 0};
    truth[i].angles = estimates[i].angles = Vector3d::Zero();
  }
  const auto pairs = pairs_of(estimates, truth, any_gap);
  const auto errors = errors_of(pairs.all, std::chrono::seconds{10});
  EXPECT_EQ(errors.rpe_pairs, 381U) << "200 s less 10 s, twice a second";
  EXPECT_NEAR(errors.rpe_m->rms, 0.2, 1e-9) << "1 % of 20 m";
  EXPECT_NEAR(*errors.end_m, 4, 1e-9);
  EXPECT_NEAR(errors.ate_m->mean, 2, 1e-9);
}

/// Truth at rest, estimates that drift north by 0.1 m/s, each `step_s`.
Errors drifting(double step_s, double until_s, double gap_from_s = 0, double gap_to_s = 0) {
  Track estimates, truth;
  for (double t = 0; t <= until_s; t += step_s) {
    if (t > gap_from_s && t < gap_to_s) continue;
    truth.push_back({.at = at(t), .position_ned = {0, 0, 0}});
    estimates.push_back({.at = at(t), .position_ned = {0.1 * t, 0, 0}});
  }
  return errors_of(pairs_of(estimates, truth, any_gap).all, std::chrono::seconds{1});
}

TEST(Score, ARelativeErrorIsOfPairsThatAreTheIntervalApart) {
  const auto dense = drifting(0.25, 70);
  EXPECT_EQ(dense.rpe_pairs, 277U) << "281 estimates, the last four have none a second later";
  EXPECT_NEAR(dense.rpe_m->max, 0.1, 1e-9);
  const auto sparse = drifting(10, 70);
  EXPECT_EQ(sparse.pairs, 8U);
  EXPECT_EQ(sparse.rpe_pairs, 0U) << "10 s are no 1 s";
  EXPECT_FALSE(sparse.rpe_m);
}

TEST(Score, ARelativeErrorIsNotTakenAcrossAGap) {
  const auto errors = drifting(0.25, 70, 20, 40);
  EXPECT_NEAR(errors.rpe_m->max, 0.1, 1e-9);
  EXPECT_EQ(errors.rpe_pairs, 277U - 79U - 4U) << "those in the gap, and the last before it";
}

TEST(Score, TheSquareOfAnErrorOverItsVarianceIsTheNees) {
  auto estimates = moved(circle(), heading(0), {2, 3, 4});
  for (State& state : estimates)
    state.position_m2 = Eigen::Matrix3d(Vector3d{4, 9, 4}.asDiagonal());
  EXPECT_NEAR(compared(estimates, Alignment::none).position_nees.mean.value(), (1 + 1 + 4) / 3.0,
              1e-9);
  estimates[7].position_m2 = Eigen::Matrix3d::Zero();
  const auto errors = compared(estimates, Alignment::none);
  EXPECT_EQ(errors.position_nees.covariances, 401U);
  EXPECT_EQ(errors.position_nees.pairs, 400U) << "a covariance of zeros cannot be inverted";
}

TEST(Score, TheTruthIsTakenBetweenItsStatesAndNotAcrossAGap) {
  const auto state = [](double t, double north, double angle) {
    return State{.at = at(t),
                 .position_ned = {north, 0, 0},
                 .angles = {0, 0, angle},
                 .velocity = {north, 0, 0}};
  };
  const Track truth{state(0, 0, 0), state(1, 10, 90 * degree), state(9, 90, 0)};
  Track estimates;
  for (const double t : {-1., 0., 0.25, 0.25, 5., 10.}) estimates.push_back({.at = at(t)});
  const auto pairs = pairs_of(estimates, truth, milliseconds{1500});
  ASSERT_EQ(pairs.all.size(), 2U);
  EXPECT_NEAR(pairs.all[1].truth.position_ned.x(), 2.5, 1e-12);
  EXPECT_NEAR(pairs.all[1].truth.velocity.x(), 2.5, 1e-12);
  EXPECT_NEAR(pairs.all[1].truth.angles.z(), 22.5 * degree, 1e-7);
  EXPECT_EQ(pairs.without_truth, 3U) << "before, in the gap, after";
  EXPECT_EQ(pairs.out_of_order, 1U);
}

TEST(Score, AVehicleThatDoesNotMoveIsShiftedAlone) {
  Track still(5), off(5);
  for (std::size_t i = 0; i < 5; ++i) {
    still[i].at = off[i].at = at(static_cast<double>(i));
    still[i].position_ned = {0, 0, 0};
    off[i].position_ned = {1, 2, 3};
  }
  auto pairs = pairs_of(off, still, any_gap);
  EXPECT_THAT(align(pairs.all, Alignment::rigid), testing::HasSubstr("is not determined"));
  EXPECT_NEAR(errors_of(pairs.all, milliseconds{1}).ate_m->max, 0, 1e-12);
}

}  // namespace errors_test
}  // namespace drydock::score
