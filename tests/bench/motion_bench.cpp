#include <benchmark/benchmark.h>

#include <chrono>

#include "estimators/hydrodynamics/model.hpp"
#include "estimators/vehicle/vehicle.hpp"
#include "hil/motion/vehicle/vehicle_trajectory.hpp"
#include "rig_config/load.hpp"

/// Cost of the truth for the velocity-filter paper's 5.5 h mission at 100 Hz.
namespace {

using namespace drydock;
using Clock = std::chrono::steady_clock;

const rig_config::MissionConfig& paper_mission() {
  static const auto mission =
      rig_config::load_mission(DRYDOCK_SOURCE_DIR "/rig_config/missions/velocity-paper.toml")
          .value();
  return mission;
}

/// Seconds for one Runge-Kutta step of the bare equations.
double bare_step_s() {
  const hydrodynamics::Model model{vehicle::dimensional(paper_mission().vehicle.value())};
  constexpr int steps = 200'000;
  hydrodynamics::State state = 3 * hydrodynamics::State::Unit(0);
  const auto begin = Clock::now();
  for (int i = 0; i < steps; ++i) state = model.step(state, {0.02, 0, 0, 3}, 0.01);
  benchmark::DoNotOptimize(state.data());
  return std::chrono::duration<double>(Clock::now() - begin).count() / steps;
}

void truth_of_the_mission(benchmark::State& state) {
  const auto start = measurement::stamp_from_ns(0);
  const double bare_s = bare_step_s();
  long truths = 0;
  const auto begin = Clock::now();
  for (auto _ : state) {
    const motion::VehicleTrajectory trajectory(paper_mission(), start);
    for (auto at = start; at < trajectory.end(); at += std::chrono::milliseconds{10}, ++truths) {
      auto truth = trajectory.at(at);
      benchmark::DoNotOptimize(&truth);
    }
  }
  const double each_s =
      std::chrono::duration<double>(Clock::now() - begin).count() / static_cast<double>(truths);
  state.SetItemsProcessed(truths);
  state.counters["bare_steps_each"] = each_s / bare_s;
}
BENCHMARK(truth_of_the_mission)->Name("motion: truth of 5.5 h at 100 Hz")->Unit(benchmark::kSecond);

}  // namespace

BENCHMARK_MAIN();
