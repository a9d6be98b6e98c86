#include <benchmark/benchmark.h>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/earth.hpp"
#include "estimators/navigation/aided_navigation.hpp"
#include "estimators/vehicle/vehicle.hpp"
#include "estimators/velocity/coupled_navigation.hpp"
#include "estimators/velocity/velocity_filter.hpp"
#include "rig_config/load.hpp"

/// Cost of inertial navigation, of its aiding and of the velocity filter. The reference, in the
/// same run on the same machine: one propagation of a 15-state covariance with full matrices.
namespace {

using namespace drydock;
using Eigen::Vector3d;

constexpr double dt = 0.01;
const Vector3d turn = Vector3d{0.01, -0.02, 0.03} * dt, push = Vector3d{0.2, 0.1, -9.8} * dt;

navigation::NavigationState under_way() {
  return {{0.63, 2.25, -100}, {2, 2, 0.1}, frame::body_to_ned({0.02, -0.1, 0.8})};
}

void dense_covariance(benchmark::State& state) {
  using Matrix = Eigen::Matrix<double, 15, 15>;
  Matrix transition = Matrix::Identity(), p = Matrix::Identity() * 1e-3, noise = p * 1e-9;
  transition.topRows<9>() +=
      dt * navigation::error_dynamics(under_way(), Vector3d{0.1, 0.2, -9.8}) * 1e-3;
  for (auto _ : state) {
    benchmark::DoNotOptimize(transition.data());
    p = (transition * p * transition.transpose() + noise).eval();
    benchmark::DoNotOptimize(p.data());
    benchmark::ClobberMemory();
  }
}
BENCHMARK(dense_covariance)->Name("floor: 15 states by full matrices");

void mechanization(benchmark::State& state) {
  navigation::Sdins sdins(under_way(), navigation::HeightLoop::of_time_constant(30));
  navigation::IncrementSum sum;
  for (auto _ : state) {
    sum.add(turn, push, dt);
    sdins.step(sum.take(), -100);
    benchmark::DoNotOptimize(&sdins);
    benchmark::ClobberMemory();
  }
}
BENCHMARK(mechanization)->Name("navigation: SDINS, IMU sample");

void navigation_and_covariance(benchmark::State& state) {
  navigation::AidedNavigation aided(under_way(), {});
  for (auto _ : state) {
    aided.add_imu(turn, push, dt);
    aided.step(-100);
    benchmark::DoNotOptimize(&aided);
    benchmark::ClobberMemory();
  }
}
BENCHMARK(navigation_and_covariance)->Name("navigation: SDINS + 15 states, IMU sample");

void aiding_update(benchmark::State& state) {
  navigation::AidedNavigation aided(under_way(), {});
  for (auto _ : state) {
    benchmark::DoNotOptimize(aided.update_velocity({2.8, 0, 0}, Vector3d::Constant(0.03)));
    benchmark::DoNotOptimize(aided.update_height(-100, 0.1));
  }
}
BENCHMARK(aiding_update)->Name("navigation: aiding by velocity and depth");

const hydrodynamics::Vehicle& nps_vehicle() {
  static const hydrodynamics::Vehicle vehicle = vehicle::dimensional(
      rig_config::load_vehicle(DRYDOCK_SOURCE_DIR "/rig_config/vehicles/nps-auv-ii.toml").value());
  return vehicle;
}

velocity::Simulated cruising() {
  velocity::Simulated at{.height_m = -100};
  at.velocity << 3, 0.01, 0.01, 0, 0, 0.01;
  return at;
}

/// A step at 100 Hz: prediction, gyro and depth; a log at 2 Hz and a DVL at 1 Hz.
void velocity_filter(benchmark::State& state) {
  velocity::VelocityFilter filter(hydrodynamics::Model{nps_vehicle()}, cruising());
  const velocity::Setting setting{frame::ned_to_body({0.02, -0.01, 0.8}),
                                  frame::earth_rate_ned(0.63)};
  int k = 0;
  for (auto _ : state) {
    filter.predict(setting, {0.01, 0.01, 0, 3}, dt);
    filter.update_rate({0, 0, 0.01});
    filter.update_height(-100);
    if (++k % 50 == 0) filter.update_log(3);
    if (k % 100 == 0) filter.update_velocity({3, 0, 0});
    benchmark::DoNotOptimize(&filter);
    benchmark::ClobberMemory();
  }
}
BENCHMARK(velocity_filter)->Name("velocity: filter step at 100 Hz");

void coupled_step(benchmark::State& state) {
  velocity::CoupledNavigation coupled(under_way(), nps_vehicle(), {});
  for (auto _ : state) {
    for (int i = 0; i < 10; ++i) {
      coupled.add_imu(turn, push, dt);
      coupled.add_height(-100);
    }
    coupled.step({0.01, 0.01, 0, 3});
    benchmark::DoNotOptimize(&coupled);
    benchmark::ClobberMemory();
  }
}
BENCHMARK(coupled_step)->Name("velocity: coupled navigation, ten IMU samples");

}  // namespace

BENCHMARK_MAIN();
