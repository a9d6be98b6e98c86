#include "estimators/velocity/vehicle_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "estimators/frame/attitude.hpp"
#include "tests/estimators/velocity/support.hpp"

namespace drydock::velocity::vehicle_watch_test {
namespace {

using Eigen::Vector3d;

constexpr double dt = 0.1, degree = 0.0174533;

/// A vehicle after its equations, and an IMU whose roll gyro may be off.
struct Watched {
  hydrodynamics::Vehicle vehicle = velocity::test::nps_vehicle();
  hydrodynamics::Model truth{vehicle};
  VehicleWatch watch{vehicle};
  hydrodynamics::State state = hydrodynamics::State::Zero();
  double gyro_off = 0, roll_off = 0;  ///< rad/s; rad

  Watched() { state[0] = 3; }

  /// `told`: what the actuators say.
  void step(const hydrodynamics::Control& control, const hydrodynamics::Control& told,
            double drift_radps2 = 0) {
    const hydrodynamics::State before = state;
    for (int i = 0; i < 10; ++i) state = truth.step(state, control, dt / 10);
    gyro_off += drift_radps2 * dt;
    roll_off += gyro_off * dt;
    Measured m;
    m.velocity = state.head<6>();
    m.velocity(3) += gyro_off;
    m.change = state.head<6>() - before.head<6>();
    m.change(3) += drift_radps2 * dt;
    m.velocity_sigma = Vector3d::Constant(0.003);
    m.ned_to_body = frame::ned_to_body({state[9] + roll_off, state[10], state[11]});
    m.earth_rate_ned.setZero();
    watch.add(m, told, dt);
  }
};

const hydrodynamics::Control ahead{0, 0, 0, 3};

TEST(VehicleWatch, AgreesWithItsVehicleUnderHardRudderAndPlanes) {
  Watched watched;
  for (int i = 0; i < 900; ++i) {
    const hydrodynamics::Control control{i < 300 ? 0.2 : -0.2, i < 600 ? 0.05 : -0.05, 0, 3};
    watched.step(control, control);
    ASSERT_FALSE(watched.watch.contradicts()) << i << ' ' << watched.watch.statistic().transpose();
  }
}

TEST(VehicleWatch, SeesAGyroThatDriftsBeforeTheRollIsATenthOfADegreeWrong) {
  // .05 deg/s2 for t seconds is c T (1 - e^(-t/T)) rad/s in the sum of T = 2 s, and the limit is
  // 4.5 times 1e-4 rad/s and more.
  Watched watched;
  for (int i = 0; i < 600; ++i) watched.step(ahead, ahead);
  double t = 0;
  while (!watched.watch.contradicts() && t < 20) {
    watched.step(ahead, ahead, 0.05 * degree);
    t += dt;
  }
  const double sum = 0.05 * degree * 2 * -std::expm1(-t / 2);
  EXPECT_GT(sum, VehicleWatch::limit * 1e-4);
  EXPECT_LT(t, 2);
  EXPECT_LT(watched.roll_off, 0.1 * degree);
}

TEST(VehicleWatch, ARudderThatTellsAWrongAngleContradictsNoImu) {
  Watched watched;
  for (int i = 0; i < 600; ++i) watched.step(ahead, ahead);
  for (int i = 0; i < 300; ++i) {
    watched.step(ahead, {0.1, 0, 0, 3});
    if (i > 5) {
      ASSERT_FALSE(watched.watch.contradicts())
          << i << ' ' << watched.watch.statistic().transpose();
    }
  }
}

TEST(VehicleWatch, NumbersThatAreNoneContradictUntilItBeginsAnew) {
  Watched watched;
  watched.step(ahead, ahead);
  watched.step(ahead, ahead, std::nan(""));
  EXPECT_TRUE(watched.watch.contradicts());
  watched.watch.clear();
  EXPECT_FALSE(watched.watch.contradicts());
}

}  // namespace
}  // namespace drydock::velocity::vehicle_watch_test
