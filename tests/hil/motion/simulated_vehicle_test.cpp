#include "hil/motion/vehicle/simulated_vehicle.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/estimators/hydrodynamics/support.hpp"
#include "tests/test_name.hpp"

/// The NPS AUV II with its actuators.
namespace drydock::motion {
namespace simulated_vehicle_test {

using hydrodynamics::State;
using hydrodynamics::test::nps_file;
using hydrodynamics::test::Table;

constexpr double rad = std::numbers::pi / 180;
constexpr double cruise_mps = 0.012 * 1500 * 2 * std::numbers::pi / 60;

/// The program that made the tables had no rate limits.
rig_config::VehicleConfig without_rate_limits() {
  auto config = nps_file();
  for (auto* surface : {&config.rudder, &config.stern_planes, &config.bow_planes})
    surface->rate_limit_radps.reset();
  return config;
}

/// Another program (MSS npsauv.m, four corrections) with the cross-flow integrals that the
/// quadratic coefficients approximate. The bounds are the differences of these two descriptions.
struct Manoeuvre {
  const char* file;
  double delta_r, delta_s, until_s;  ///< from 10 s on
};

class Npsauv : public testing::TestWithParam<Manoeuvre> {};

TEST_P(Npsauv, IsFollowedWithinWhatTheTwoModelsDiffer) {
  const Manoeuvre& manoeuvre = GetParam();
  const Table table(manoeuvre.file);
  if (table.empty()) GTEST_SKIP() << "corpora absent: vehicle";
  SimulatedVehicle vehicle(without_rate_limits(), cruise_mps * State::Unit(0));
  State worst = State::Zero();
  for (std::size_t row = 0; row < table.rows(); ++row) {
    State expected;
    expected << table.velocity(row), table.at(row, "x"), table.at(row, "y"), table.at(row, "z"),
        table.at(row, "phi"), table.at(row, "theta"), table.at(row, "psi");
    worst = worst.cwiseMax((vehicle.state() - expected).cwiseAbs());
    for (int k = 0; k < 10; ++k) {
      const double t = (row * 10 + k) * 0.02;
      const bool deflected = t > 10 - 1e-9 && t < manoeuvre.until_s - 1e-9;
      vehicle.step(
          {deflected ? manoeuvre.delta_r : 0, deflected ? manoeuvre.delta_s : 0, 0, cruise_mps},
          0.02);
    }
  }
  EXPECT_LT(worst[0], 0.011) << "u";
  EXPECT_LT(worst[1], 0.003) << "v";
  EXPECT_LT(worst[2], 0.001) << "w";
  EXPECT_LT(worst[5], 0.13 * rad) << "r";
  EXPECT_LT(worst[8], 0.14) << "z";
  EXPECT_LT(worst[10], 0.11 * rad) << "theta";
}

INSTANTIATE_TEST_SUITE_P(
    Manoeuvres, Npsauv,
    testing::Values(Manoeuvre{"npsauv_corrected_rudder_p10.csv", 10 * rad, 0, 1e9},
                    Manoeuvre{"npsauv_corrected_stern_p3.csv", 0, 3 * rad, 1e9},
                    Manoeuvre{"npsauv_corrected_stern_pulse_m5.csv", 0, -5 * rad, 20}),
    [](const auto& one) { return drydock::test::test_name(one.param.file); });

TEST(SimulatedVehicle, TurnsToPortOnARadiusOf29Metres) {
  SimulatedVehicle vehicle(nps_file(), cruise_mps * State::Unit(0));
  for (int i = 0; i < 10000; ++i) vehicle.step({10 * rad, 0, 0, cruise_mps}, 0.02);
  const double speed = vehicle.state().head<3>().norm();
  const double yaw_rate = -vehicle.state()[5] / std::cos(vehicle.state()[10]);
  EXPECT_GT(yaw_rate, 0);
  EXPECT_NEAR(speed / yaw_rate, 29.44, 0.5);
}

TEST(SimulatedVehicle, ComesToTheCommandedSpeed) {
  SimulatedVehicle vehicle(nps_file(), State::Zero());
  for (int i = 0; i < 20000; ++i) vehicle.step({0, 0, 0, 3}, 0.02);
  EXPECT_NEAR(vehicle.state()[0], 3, 1e-3);
  EXPECT_NEAR(vehicle.actuators().propeller_radps() * 60 / (2 * std::numbers::pi), 2387.3, 0.1);
}

TEST(SimulatedVehicle, AsymmetryMakesItDriftOnAStraightCourse) {
  const auto drift_after_a_minute = [](const std::string& file) {
    SimulatedVehicle vehicle(nps_file(file), cruise_mps * State::Unit(0));
    for (int i = 0; i < 3000; ++i) vehicle.step({0, 0, 0, cruise_mps}, 0.02);
    return vehicle.state().segment<2>(1).cwiseAbs().minCoeff();  // v and w
  };
  EXPECT_EQ(drift_after_a_minute("nps-auv-ii"), 0);
  EXPECT_GT(drift_after_a_minute("nps-auv-ii-asymmetric"), 1e-3);
}

}  // namespace simulated_vehicle_test
}  // namespace drydock::motion
