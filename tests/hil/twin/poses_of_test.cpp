#include "hil/twin/poses_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace drydock::twin {
namespace {

constexpr frame::Position origin{0.6, 2, 0};
constexpr double radius_m = 20, rate_radps = 0.1;

/// A circle of 20 m at 2 m/s, at times that are not equally spaced, with tilt sensors' noise.
std::vector<smoothing::TrackPoint> circle(double tilt_noise_rad) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal(0, 1);
  std::vector<smoothing::TrackPoint> track;
  for (int k = 0; k <= 1000; ++k) {
    smoothing::TrackPoint point;
    point.time_s = 0.1 * k + (k % 3 == 1 && k < 1000 ? 0.04 : 0);
    const double angle = rate_radps * point.time_s;
    point.position =
        frame::at_ned_offset(origin, {radius_m * std::sin(angle), -radius_m * std::cos(angle), 5});
    point.velocity_ned =
        radius_m * rate_radps * Eigen::Vector3d{std::cos(angle), std::sin(angle), 0};
    point.attitude = {tilt_noise_rad * normal(random), 0, frame::wrap_pi(angle)};
    track.push_back(point);
  }
  return track;
}

// Hermite's cubic is within h^4 / 384 times the fourth derivative, here 0.1^4 * 20 m * 0.14^4.
TEST(PosesOf, LieOnTheTrackAtEqualSteps) {
  const auto poses = poses_of(circle(0), 1);
  ASSERT_EQ(poses.size(), 101u);
  for (const auto& pose : poses) {
    const double angle = rate_radps * pose.t_s;
    const auto offset = frame::ned_offset(origin, pose.position);
    EXPECT_NEAR(offset.x(), radius_m * std::sin(angle), 2e-6);
    EXPECT_NEAR(offset.y(), -radius_m * std::cos(angle), 2e-6);
    EXPECT_NEAR(frame::wrap_pi(frame::euler(pose.body_to_ned).yaw - angle), 0, 0.006);
  }
  EXPECT_NEAR(poses[50].t_s, 50, 1e-9);
}

TEST(PosesOf, AverageTheNoiseOfTiltSensors) {
  const auto poses = poses_of(circle(0.01), 1);
  double square = 0;
  for (std::size_t i = 1; i + 1 < poses.size(); ++i)
    square += std::pow(frame::euler(poses[i].body_to_ned).roll, 2);
  const double rms = std::sqrt(square / static_cast<double>(poses.size() - 2));
  EXPECT_NEAR(rms, 0.01 / std::sqrt(10.0), 0.0008);  // ten or so points within a second
}

// Pose files allow 90 degrees from line to line. Here the heading is turned by 170 in one step.
TEST(PosesOf, AQuickTurnGetsMorePoses) {
  auto track = circle(0);
  for (auto& point : track)
    if (point.time_s > 40.5) point.attitude.yaw = frame::wrap_pi(point.attitude.yaw + 2.97);
  const auto poses = poses_of(track, 1);
  EXPECT_GT(poses.size(), 101u);
  for (std::size_t i = 1; i < poses.size(); ++i) {
    EXPECT_GT(poses[i].t_s, poses[i - 1].t_s);
    EXPECT_LT(poses[i].body_to_ned.angularDistance(poses[i - 1].body_to_ned), 1.01);
  }
}

TEST(PosesOf, NeedTwoSteps) { EXPECT_THROW(poses_of(circle(0), 90), std::runtime_error); }

}  // namespace
}  // namespace drydock::twin
