#include "estimators/velocity/coupled_navigation.hpp"

#include <gtest/gtest.h>

#include <random>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/earth.hpp"
#include "tests/estimators/pipeline/counting_new.hpp"
#include "tests/estimators/velocity/support.hpp"

namespace drydock::velocity {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// A steady, straight and level run at 3 m/s through moving water. The sensors have white noise.
class StraightRun {
 public:
  StraightRun(const Vector2d& current, double log_scale)
      : current_(current.x(), current.y(), 0),
        log_scale_(log_scale),
        navigation_(truth_, test::nps_vehicle(), {}) {
    truth_.position = {0.6, 2.2, -50};
    truth_.body_to_ned = frame::body_to_ned({0, 0, heading_});
    truth_.velocity_ned = truth_.body_to_ned * Vector3d{3, 0, 0} + current_;
    navigation_ = CoupledNavigation(truth_, test::nps_vehicle(), {});
  }

  void sail(int steps, bool ground) {
    const Vector3d water{3, 0, 0};
    for (int k = 1; k <= steps; ++k) {
      sail_a_step();
      if (k % 5 == 0) navigation_.update_log((1 + log_scale_) * water.norm() + normal(0.03));
      if (ground && k % 10 == 0)
        navigation_.update_velocity(truth_.body_to_ned.conjugate() * truth_.velocity_ned +
                                    Vector3d{normal(0.03), normal(0.03), normal(0.03)});
    }
  }

  void sail_a_step() {
    const Vector3d earth_rate = frame::earth_rate_ned(truth_.position.latitude_rad);
    const Vector3d transport = frame::transport_rate_ned(
        truth_.position.latitude_rad, truth_.position.height_m, truth_.velocity_ned);
    const Vector3d g{0, 0, frame::gravity(truth_.position.latitude_rad, truth_.position.height_m)};
    const auto to_body = truth_.body_to_ned.conjugate();
    navigation_.add_imu(
        to_body * (earth_rate + transport) * 0.1,
        to_body * ((2 * earth_rate + transport).cross(truth_.velocity_ned) - g) * 0.1, 0.1);
    navigation_.add_height(truth_.position.height_m + normal(0.16));
    truth_.position.latitude_rad +=
        0.1 * truth_.velocity_ned.x() / (frame::meridian_radius(truth_.position.latitude_rad) - 50);
    truth_.position.longitude_rad +=
        0.1 * truth_.velocity_ned.y() /
        ((frame::transverse_radius(truth_.position.latitude_rad) - 50) *
         std::cos(truth_.position.latitude_rad));
    navigation_.step({.u_c = 3});
  }

  const CoupledNavigation& navigation() const { return navigation_; }
  CoupledNavigation& navigation() { return navigation_; }

 private:
  double normal(double sigma) { return std::normal_distribution<double>(0, sigma)(random_); }

  std::mt19937_64 random_{3};
  double heading_ = 0.7;
  Vector3d current_;
  double log_scale_;
  navigation::NavigationState truth_;
  CoupledNavigation navigation_;
};

TEST(CoupledNavigation, LearnsACurrentFromTheDvlAndKeepsIt) {
  // The current is across, so the sway equation can separate it from the vehicle's own motion.
  const Vector2d across = 0.3 * Vector2d{-std::sin(0.7), std::cos(0.7)};
  StraightRun run(across, 0);
  run.sail(3000, true);
  run.sail(600, false);
  EXPECT_LT((run.navigation().current_ned() - across).norm(), 0.02);
}

TEST(CoupledNavigation, HoldsACurrentToBeAbsentWhenTheDvlShowedNone) {
  StraightRun run(Vector2d::Zero(), 0);
  run.sail(3000, true);
  EXPECT_GT(run.navigation().covariance()(current_error, current_error), 1e-8);
  run.sail(100, false);
  EXPECT_LT(run.navigation().covariance()(current_error, current_error), 1e-8);
  EXPECT_LT(run.navigation().current_ned().norm(), 1e-4);
}

TEST(CoupledNavigation, OpensTheQuestionAgainWhenTheDvlIsBack) {
  StraightRun run(Vector2d::Zero(), 0);
  run.sail(3000, true);
  run.sail(100, false);
  run.sail(10, true);
  EXPECT_GT(run.navigation().covariance()(current_error, current_error), 1e-6);
}

TEST(CoupledNavigation, ForgetsNothingWhenTheBedComesAndGoes) {
  // At the edge of its range a DVL is silent for some seconds, gives one value and is silent again.
  StraightRun run(Vector2d::Zero(), 0);
  run.sail(3000, true);
  const Eigen::Vector4d known =
      run.navigation().covariance().diagonal().segment<4>(current_error).cwiseSqrt();
  for (int flicker = 0; flicker < 5; ++flicker) {
    run.sail(60, false);
    run.sail(10, true);
  }
  const Eigen::Vector4d now =
      run.navigation().covariance().diagonal().segment<4>(current_error).cwiseSqrt();
  for (int i = 0; i < 4; ++i) EXPECT_LE(now(i), known(i)) << i;
}

TEST(CoupledNavigation, AllocatesNothing) {
  StraightRun run(Vector2d::Zero(), 0);
  run.sail(100, true);
  const auto before = pipeline::test::allocations();
  run.sail(100, false);  // with a weighing of the hypotheses
  EXPECT_EQ(pipeline::test::allocations(), before);
}

}  // namespace
}  // namespace drydock::velocity
