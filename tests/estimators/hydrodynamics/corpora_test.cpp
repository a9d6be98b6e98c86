#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "estimators/frame/attitude.hpp"
#include "tests/estimators/hydrodynamics/support.hpp"
#include "tests/test_name.hpp"

/// The NPS AUV II against an independent implementation of the same equations.
namespace drydock::hydrodynamics::test {
namespace {

constexpr double cruise_mps = 0.012 * 1500 * 2 * M_PI / 60;
constexpr std::array state_names{"u", "v", "w", "p",   "q",     "r",
                                 "x", "y", "z", "phi", "theta", "psi"};

State cruise() { return cruise_mps * State::Unit(0); }

Matrix6 cruise_partials() {
  return nps_auv()
      .partials(cruise().head<6>(), Eigen::Matrix3d::Identity(), {.u_c = cruise_mps})
      .by_velocity;
}

TEST(NpsAuv, AccelerationsAreThoseOfTheSpotCheck) {
  const Table table("gh_xdot_spotcheck.csv");
  if (table.empty()) GTEST_SKIP() << "corpora absent: vehicle";
  const Model model = nps_auv();
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const frame::Euler attitude{table.at(i, "phi"), table.at(i, "theta"), table.at(i, "psi")};
    const Control control{table.at(i, "delta_r"), table.at(i, "delta_s"), table.at(i, "delta_b"),
                          table.at(i, "u_c")};
    const Velocity rate =
        model.acceleration(table.velocity(i), frame::ned_to_body(attitude), control);
    const Velocity expected{table.at(i, "du"), table.at(i, "dv"), table.at(i, "dw"),
                            table.at(i, "dp"), table.at(i, "dq"), table.at(i, "dr")};
    EXPECT_LT((rate - expected).norm(), 1e-9 * expected.norm()) << "row " << i;
  }
}

struct Series {
  const char* file;
  double delta_r, delta_s, until_s;  ///< from 10 s on
};

class NpsAuvSeries : public testing::TestWithParam<Series> {};

TEST_P(NpsAuvSeries, IsFollowedForItsWholeLength) {
  const Series& series = GetParam();
  const Table table(series.file);
  if (table.empty()) GTEST_SKIP() << "corpora absent: vehicle";
  const Model model = nps_auv();
  State state = cruise();
  double worst = 0;
  constexpr int steps_a_row = 10;  // 0.02 s, 5 Hz
  for (std::size_t row = 0; row < table.rows(); ++row) {
    ASSERT_NEAR(table.at(row, "t"), row * 0.2, 1e-9);
    for (int i = 0; i < 12; ++i)
      worst = std::max(worst, std::abs(state[i] - table.at(row, state_names[i])));
    for (int k = 0; k < steps_a_row; ++k) {
      const double t = (row * steps_a_row + k) * 0.02;
      const bool deflected = t > 10 - 1e-9 && t < series.until_s - 1e-9;
      const Control control{deflected ? series.delta_r : 0, deflected ? series.delta_s : 0, 0,
                            cruise_mps};
      state = model.step(state, control, 0.02);
    }
  }
  EXPECT_LT(worst, 1e-5);
  RecordProperty("worst", std::to_string(worst * 1e9) + "e-9");
}

INSTANTIATE_TEST_SUITE_P(Manoeuvres, NpsAuvSeries,
                         testing::Values(Series{"gh_rudder_p10.csv", 10 * degree, 0, 1e9},
                                         Series{"gh_rudder_m10.csv", -10 * degree, 0, 1e9},
                                         Series{"gh_stern_p3.csv", 0, 3 * degree, 1e9},
                                         Series{"gh_stern_pulse_m5.csv", 0, -5 * degree, 20}),
                         [](const auto& one) { return drydock::test::test_name(one.param.file); });

TEST(NpsAuv, CruisePartialsAreThoseOfTheTable) {
  const Table table("gh_cruise_jacobian.csv");
  if (table.empty()) GTEST_SKIP() << "corpora absent: vehicle";
  // The table is a central difference with the step 1e-5. At rest it gives 1e-5 v for v|v|.
  const Model model = nps_auv();
  const Matrix6 analytic = cruise_partials();
  const auto at = [&](const Velocity& change) {
    return model.acceleration(cruise().head<6>() + change, Eigen::Matrix3d::Identity(),
                              {.u_c = cruise_mps});
  };
  for (int j = 0; j < 6; ++j) {
    const Velocity step = 1e-5 * Velocity::Unit(j);
    const Velocity difference = (at(step) - at(-step)) / 2e-5;
    for (int i = 0; i < 6; ++i) {
      EXPECT_NEAR(difference[i], table.cell(i, j), 5e-9) << i << j;
      EXPECT_NEAR(analytic(i, j), table.cell(i, j), 1e-6) << i << j;
    }
  }
}

TEST(NpsAuv, CruiseIsSteadyAndStable) {
  const Velocity ahead = cruise().head<6>();
  const Eigen::Matrix3d level = Eigen::Matrix3d::Identity();
  EXPECT_LT(nps_auv().acceleration(ahead, level, {.u_c = cruise_mps}).norm(), 1e-15);
  Eigen::Matrix<double, 6, 1> modes = cruise_partials().eigenvalues().real();
  std::ranges::sort(modes);
  const Velocity expected{-2.007, -0.805, -0.692, -0.593, -0.189, -0.035};
  EXPECT_LT((modes - expected).cwiseAbs().maxCoeff(), 1e-3);
}

}  // namespace
}  // namespace drydock::hydrodynamics::test
