#include "estimators/velocity/sway_model.hpp"

#include <gtest/gtest.h>

#include "estimators/frame/attitude.hpp"
#include "tests/estimators/velocity/support.hpp"

namespace drydock::velocity {
namespace {

using Eigen::Vector3d;

/// Runs a sway model and the full equations side by side under hard rudder, in steps of 0.1 s.
struct Beside {
  hydrodynamics::Vehicle vehicle;
  SwayModel sway{vehicle};
  hydrodynamics::State state = hydrodynamics::State::Zero();
  double worst = 0, largest = 0;

  explicit Beside(const hydrodynamics::Vehicle& of) : vehicle(of) { state[0] = 3; }

  void sail(const hydrodynamics::Model& truth, int steps) {
    for (int k = 0; k < steps; ++k) {
      const hydrodynamics::Control control{k < 300 ? 0.2 : -0.2, 0.02, 0, 3};
      const hydrodynamics::State before = state;
      for (int i = 0; i < 10; ++i) state = truth.step(state, control, 0.01);
      const Vector3d rate = (before.segment<3>(3) + state.segment<3>(3)) / 2;
      const auto to_body = frame::ned_to_body({state[9], state[10], state[11]});
      sway.step({.u = (before[0] + state[0]) / 2,
                 .w = (before[2] + state[2]) / 2,
                 .rate = rate,
                 .rate_change = (state.segment<3>(3) - before.segment<3>(3)) / 0.1,
                 .earth_rate = Vector3d::Zero(),
                 .down_y = to_body(1, 2)},
                control, 0.1);
      worst = std::max(worst, std::abs(sway.v() - state[1]));
      largest = std::max(largest, std::abs(state[1]));
    }
  }
};

TEST(SwayModel, SwaysAsTheFullEquationsDo) {
  for (const char* hull : {"nps-auv-ii", "nps-auv-ii-asymmetric"}) {
    const auto vehicle = test::nps_vehicle(hull);
    Beside beside(vehicle);
    beside.sail(hydrodynamics::Model{vehicle}, 600);
    EXPECT_GT(beside.largest, 0.1) << hull;
    EXPECT_LT(beside.worst, 0.01 * beside.largest) << hull;
  }
}

TEST(SwayModel, ItsSensitivityIsHowASmallFactorMovesV) {
  const auto vehicle = test::nps_vehicle("nps-auv-ii-asymmetric");
  const hydrodynamics::Model truth{vehicle};
  Beside plain(vehicle);
  plain.sail(truth, 200);
  for (int cause = 0; cause < SwayModel::causes; ++cause) {
    const double e = 1e-3;
    Beside more(vehicle), less(vehicle);
    more.sway.correct(-e * SwayModel::PerCause::Unit(cause));
    less.sway.correct(e * SwayModel::PerCause::Unit(cause));
    more.sail(truth, 200);
    less.sail(truth, 200);
    const double slope = (more.sway.v() - less.sway.v()) / (2 * e);
    EXPECT_NEAR(plain.sway.sensitivity()(cause), slope, 0.02 * std::abs(slope) + 1e-6) << cause;
  }
}

TEST(SwayModel, TakingAFactorOutTakesOutWhatItDid) {
  Beside beside(test::nps_vehicle());
  beside.sail(hydrodynamics::Model{beside.vehicle}, 100);
  const double v = beside.sway.v();
  const SwayModel::PerCause error{0.1, -0.05, 0.02};
  beside.sway.correct(error);
  EXPECT_DOUBLE_EQ(beside.sway.v(), v - beside.sway.sensitivity().dot(error));
  EXPECT_EQ(beside.sway.factor_errors(), -error);
}

}  // namespace
}  // namespace drydock::velocity
