#include <benchmark/benchmark.h>

#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <random>
#include <vector>

#include "estimators/frame/attitude.hpp"
#include "estimators/hydrodynamics/model.hpp"
#include "estimators/leveling/any_leveling_filter.hpp"
#include "estimators/mixing/mixing_filter.hpp"
#include "estimators/pipeline/pipeline.hpp"
#include "estimators/roll/all_satellites.hpp"
#include "estimators/vehicle/vehicle.hpp"
#include "rig_config/load.hpp"

/// Cost of the leveling estimator (the filter alone, and a sample through the pipeline), of the
/// mixing and roll filters, and of the vehicle's equations of motion.
namespace {

using namespace drydock;
using Eigen::Vector3d;

constexpr double dt = 0.01;
const Vector3d force{0.2, 1.0, -9.8}, rate{0.01, -0.02, 0.1};

leveling::LevelingFilter started() {
  leveling::LevelingOptions options;
  options.latitude_rad = 0.6;
  leveling::LevelingFilter filter{options};
  filter.start(force, rate, 10);
  return filter;
}

void leveling_step(benchmark::State& state) {
  auto filter = started();
  for (auto _ : state) {
    filter.predict(force, rate, dt);
    filter.update_moving(10);
    benchmark::DoNotOptimize(filter);
  }
}
BENCHMARK(leveling_step)->Name("leveling: predict + update_moving");

void leveling_step_with_constraints(benchmark::State& state) {
  auto filter = started();
  for (auto _ : state) {
    filter.predict(force, rate, dt);
    filter.update_nonholonomic(dt);
    filter.update_moving(10);
    benchmark::DoNotOptimize(filter);
  }
}
BENCHMARK(leveling_step_with_constraints)
    ->Name("leveling: predict + update_nonholonomic + update_moving");

void leveling_stationary_step(benchmark::State& state) {
  auto filter = started();
  for (auto _ : state) {
    filter.predict(force, Vector3d::Zero(), dt);
    filter.update_stationary();
    benchmark::DoNotOptimize(filter);
  }
}
BENCHMARK(leveling_stationary_step)->Name("leveling: predict + update_stationary");

void augmented_leveling_step(benchmark::State& state) {
  auto options = leveling::options_for(leveling::FilterKind::augmented);
  options.latitude_rad = 0.6;
  leveling::AugmentedLevelingFilter filter{options};
  filter.start(force, rate, 10);
  for (auto _ : state) {
    filter.predict(force, rate, dt);
    filter.update_nonholonomic(dt);
    filter.update_moving(10);
    benchmark::DoNotOptimize(filter);
  }
}
BENCHMARK(augmented_leveling_step)
    ->Name("leveling, augmented: predict + update_nonholonomic + update_moving");

void leveling_output(benchmark::State& state) {
  const auto filter = started();
  for (auto _ : state) {
    benchmark::DoNotOptimize(filter.roll() + filter.pitch());
    benchmark::DoNotOptimize(filter.roll_pitch_covariance());
  }
}
BENCHMARK(leveling_output)->Name("leveling: roll, pitch and their covariance");

/// Gentle motion with the gyro noise of a low-grade unit. It reaches every level of manoeuvring.
std::vector<Vector3d> noisy_rates() {
  std::vector<Vector3d> rates;
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0, 0.0044);
  for (int i = 0; i < 4096; ++i) {
    const Vector3d swing{0.02 * std::sin(0.01 * i), 0.01 * std::sin(0.003 * i), 0.05};
    rates.push_back(swing + Vector3d{noise(random), noise(random), noise(random)});
  }
  return rates;
}

/// Processor time, in which other load does not count.
double ns_of_mixing_step(mixing::MixingType type, const std::vector<Vector3d>& rates) {
  mixing::MixingOptions options;
  options.type = type;
  options.settling_s = 0;  // while it settles, no step waits for the gains of the one before
  mixing::MixingFilter filter{options};
  filter.start(force, rate, 10);
  const std::clock_t begin = std::clock();
  for (const Vector3d& turning : rates) filter.step(force, turning, 10, dt);
  benchmark::DoNotOptimize(filter);
  const double taken_s = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return 1e9 * taken_s / static_cast<double>(rates.size());
}

/// `of_type1` is the cost relative to a step of type 1. Both are measured in turn.
void mixing_step(benchmark::State& state, mixing::MixingType type) {
  const auto rates = noisy_rates();
  double sum = 0, of_type1 = 0;
  for (auto _ : state) {
    const double ns = ns_of_mixing_step(type, rates);
    sum += ns;
    of_type1 += ns_of_mixing_step(mixing::MixingType::fixed_gain, rates);
    state.SetIterationTime(ns * 1e-9);
  }
  state.counters["of_type1"] = sum / of_type1;
}
BENCHMARK_CAPTURE(mixing_step, type1, mixing::MixingType::fixed_gain)
    ->UseManualTime()
    ->Iterations(200);
BENCHMARK_CAPTURE(mixing_step, type2, mixing::MixingType::fuzzy_inference)
    ->UseManualTime()
    ->Iterations(200);
BENCHMARK_CAPTURE(mixing_step, type3, mixing::MixingType::gain_schedule)
    ->UseManualTime()
    ->Iterations(200);
BENCHMARK_CAPTURE(mixing_step, compensated, mixing::MixingType::compensated)
    ->UseManualTime()
    ->Iterations(200);

struct Discard final : pipeline::EstimateListener {
  void on_attitude(const pipeline::AttitudeEstimate& estimate) override {
    benchmark::DoNotOptimize(&estimate);
  }
};

/// One IMU sample of 100 Hz per step. Every fiftieth step has a speed: 2 Hz.
void pipeline_step(benchmark::State& state) {
  pipeline::PipelineOptions options;
  auto& estimator = options.estimators.emplace_back();
  estimator.kind.emplace<pipeline::LevelingOptions>().log = 1;
  options.reorder_window = std::chrono::milliseconds{state.range(0)};
  Discard listener;
  auto made = pipeline::make_pipeline(options, listener);

  measurement::ImuSample imu;
  imu.specific_force = force;
  imu.angular_rate = rate;
  measurement::WaterSpeed speed;
  speed.origin.device = 1;
  speed.longitudinal_mps = 10;
  measurement::Stamp now{};
  int step = 0;
  for (auto _ : state) {
    now += std::chrono::milliseconds{10};
    if (step++ % 50 == 0) {
      speed.origin.valid_at = now;
      made->receive(speed);
    }
    imu.origin.valid_at = now;
    made->receive(imu);
  }
}
BENCHMARK(pipeline_step)
    ->Name("pipeline: IMU sample to estimate")
    ->ArgName("window_ms")
    ->Arg(0)
    ->Arg(200);

/// Ten satellites around the sky, after `state.range(0)` epochs. After these one hypothesis is
/// left; with 0 epochs all 24 begin.
roll::AllSatellites rolling(std::array<roll::Signal, 10>& signals, std::int64_t epochs) {
  for (std::size_t i = 0; i < signals.size(); ++i) {
    const auto k = static_cast<double>(i);
    signals[i].satellite = static_cast<std::uint16_t>(i);
    signals[i].toward_ned = roll::toward_ned(0.2 + 0.1 * k, 0.7 * k);
    const roll::SightLine line(signals[i].toward_ned, {0.3, 0.4}, {0, 0, 1});
    signals[i].power = roll::power_of({}, line, 1.0).value;
  }
  roll::AllSatellitesOptions options;
  options.antenna.resolution_db = 1;
  options.antenna.tracking_limit = 0.01;
  roll::AllSatellites filter(options);
  for (std::int64_t i = 0; i < epochs; ++i) filter.update({.signals = signals, .path = {0.3, 0.4}});
  return filter;
}

void roll_epoch(benchmark::State& state) {
  std::array<roll::Signal, 10> signals;
  const auto before = rolling(signals, state.range(0));
  auto filter = before;
  for (auto _ : state) {
    if (state.range(0) == 0) filter.restart();
    filter.update({.signals = signals, .path = {0.3, 0.4}});
    benchmark::DoNotOptimize(filter);
  }
}
BENCHMARK(roll_epoch)->Name("roll: epoch of ten satellites")->ArgName("after")->Arg(0)->Arg(20);

void roll_gyro_sample(benchmark::State& state) {
  std::array<roll::Signal, 10> signals;
  auto filter = rolling(signals, 20);
  for (auto _ : state) {
    filter.predict(1.57, dt);
    benchmark::DoNotOptimize(filter);
  }
}
BENCHMARK(roll_gyro_sample)->Name("roll: gyro sample");

const hydrodynamics::Model& nps_auv() {
  static const hydrodynamics::Model model{vehicle::dimensional(
      rig_config::load_vehicle(DRYDOCK_SOURCE_DIR "/rig_config/vehicles/nps-auv-ii.toml").value())};
  return model;
}

const hydrodynamics::Control control{0.1, -0.05, 0.05, 1.9};

hydrodynamics::State turning_and_diving() {
  hydrodynamics::State vehicle;
  vehicle << 1.8, 0.15, 0.05, 0.01, -0.02, -0.05, 0, 0, 10, 0.05, -0.1, 1;
  return vehicle;
}

void vehicle_right_hand_side(benchmark::State& state) {
  auto vehicle = turning_and_diving();
  for (auto _ : state) {
    benchmark::DoNotOptimize(vehicle.data());
    benchmark::ClobberMemory();
    auto derivative = nps_auv().derivative(vehicle, control);
    benchmark::DoNotOptimize(derivative.data());
    benchmark::ClobberMemory();
  }
}
BENCHMARK(vehicle_right_hand_side)->Name("vehicle: right-hand side");

void vehicle_step(benchmark::State& state) {
  auto vehicle = turning_and_diving();
  for (auto _ : state) {
    vehicle = nps_auv().step(vehicle, control, dt);
    benchmark::DoNotOptimize(vehicle.data());
    benchmark::ClobberMemory();
  }
}
BENCHMARK(vehicle_step)->Name("vehicle: Runge-Kutta step");

void vehicle_partials(benchmark::State& state) {
  const hydrodynamics::Velocity velocity = turning_and_diving().head<6>();
  const auto attitude = frame::ned_to_body({0.05, -0.1, 1});
  for (auto _ : state) {
    auto partials = nps_auv().partials(velocity, attitude, control);
    benchmark::DoNotOptimize(partials.by_velocity.data());
    benchmark::ClobberMemory();
  }
}
BENCHMARK(vehicle_partials)->Name("vehicle: partial derivatives");

}  // namespace

BENCHMARK_MAIN();
