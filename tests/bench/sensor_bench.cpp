#include <benchmark/benchmark.h>

#include "hil/sensor/imu_errors.hpp"
#include "rig_config/load.hpp"

/// Cost of the errors of one sample. A 5.5 h mission at 2000 times real time leaves 5 us for each
/// of the 100 samples a second of an inertial unit, including emulation, wire and driver.
namespace {

using namespace drydock;
using sensor::Vector3d;

measurement::ImuSample moving() {
  measurement::ImuSample sample;
  sample.angular_rate = {0.01, -0.02, 0.1};
  sample.specific_force = {0.2, 1.0, -9.8};
  return sample;
}

void imu_sample(benchmark::State& state, const char* grade) {
  const auto config =
      rig_config::load_sensor(std::string(DRYDOCK_SOURCE_DIR "/rig_config/sensors/") + grade,
                              rig_config::DeviceKind::imu)
          .value();
  sensor::ImuErrors errors(config, 100, 1, "imu");
  auto ideal = moving();
  for (auto _ : state) {
    ideal.origin.valid_at += std::chrono::milliseconds{10};
    benchmark::DoNotOptimize(errors.apply(ideal));
  }
}
BENCHMARK_CAPTURE(imu_sample, bias_and_white_noise, "leveling-paper.toml");
BENCHMARK_CAPTURE(imu_sample, table_5, "mixing-paper.toml");
BENCHMARK_CAPTURE(imu_sample, data_sheet, "xsens-mti-630.toml");

rig_config::SensorErrors bias_and_white_noise() {
  rig_config::SensorErrors errors;
  errors.bias = errors.noise = {0.1, 0.1, 0.1};
  return errors;
}

void vector_sample(benchmark::State& state) {
  sensor::ErrorModel model(bias_and_white_noise(), 100, {1, "dvl", "primary", true});
  const Vector3d ideal(2, 0.1, -0.1);
  measurement::Stamp at{};
  for (auto _ : state) {
    at += std::chrono::milliseconds{10};
    benchmark::DoNotOptimize(model.apply(ideal, at));
  }
}
BENCHMARK(vector_sample)->Name("three axes: bias, white noise");

void three_normal_numbers(benchmark::State& state) {
  sensor::RandomStream random(1, "dvl", "noise");
  for (auto _ : state) benchmark::DoNotOptimize(random.normal3());
}
BENCHMARK(three_normal_numbers)->Name("three normal numbers");

}  // namespace

BENCHMARK_MAIN();
