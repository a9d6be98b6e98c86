#include <benchmark/benchmark.h>

#include <vector>

#include "drivers/wire/canopen/cia404_imu.hpp"
#include "drivers/wire/nmea2000/nmea2000.hpp"

namespace {

using namespace drydock::wire;

/// A bus with one message of each kind that the decoder knows, and as many messages that it does
/// not know.
std::vector<CanFrame> nmea2000_traffic() {
  std::vector<CanFrame> frames{
      encode(nmea2000::Pressure{7, 5, 0, nmea2000::Pressure::water, 301325.0}),
      encode(nmea2000::Temperature{7, 5, 0, nmea2000::Temperature::sea, 281.15, {}}),
      encode(nmea2000::WaterDepth{8, 5, 42.5, 0.0, 200.0}),
      encode(nmea2000::Rudder{9, 0, 0, 0.05, 0.049}),
      encode(nmea2000::Engine{10, 0, 20.0, {}, {}}),
  };
  const std::size_t known = frames.size();
  for (std::size_t i = 0; i < known; ++i) {
    frames.push_back(j1939::blank_frame({2, 127250, j1939::global_address, 11}));
  }
  return frames;
}

std::vector<CanFrame> imu_traffic() {
  cia404_imu::ImuSet set;
  set.node = 5;
  set.rate_radps = {7.3e-5, 1e-6, -2e-6};
  set.specific_force_mps2 = {0.01, -0.02, -9.81};
  const auto frames = cia404_imu::encode(set);
  return {frames.begin(), frames.end()};
}

template <class P>
void decode(benchmark::State& state, const std::vector<CanFrame>& traffic) {
  typename P::Decoder decoder;
  for (auto _ : state) {
    for (const CanFrame& frame : traffic) benchmark::DoNotOptimize(decoder.receive(frame));
  }
  const auto frames = static_cast<double>(state.iterations()) * static_cast<double>(traffic.size());
  state.counters["frames"] = benchmark::Counter(frames, benchmark::Counter::kIsRate);
}

void nmea2000_bus(benchmark::State& state) { decode<Nmea2000>(state, nmea2000_traffic()); }
void cia404_imu_set(benchmark::State& state) { decode<Cia404Imu>(state, imu_traffic()); }

BENCHMARK(nmea2000_bus);
BENCHMARK(cia404_imu_set);

}  // namespace

BENCHMARK_MAIN();
