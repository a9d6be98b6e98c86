#include <benchmark/benchmark.h>

#include <vector>

#include "drivers/wire/can/xsens.hpp"
#include "drivers/wire/canopen/cia404_imu.hpp"
#include "drivers/wire/described/frame_codec.hpp"
#include "drivers/wire/nmea2000/nmea2000.hpp"
#include "rig_config/device_description/load_description.hpp"

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

/// Time, counter, rate of turn and acceleration, as an MTi sends them with each sample.
std::vector<CanFrame> xsens_traffic() {
  return {xsens::encode(xsens::SampleTime{1000}), xsens::encode(xsens::GroupCounter{7}),
          xsens::encode(xsens::RateOfTurn{{0.1, -0.25, 2.5}}),
          xsens::encode(xsens::Acceleration{{1.5, -2.25, 9.8}})};
}

template <class Decoder>
void decode(benchmark::State& state, const std::vector<CanFrame>& traffic, Decoder decoder) {
  for (auto _ : state) {
    for (const CanFrame& frame : traffic) benchmark::DoNotOptimize(decoder.receive(frame));
  }
  const auto frames = static_cast<double>(state.iterations()) * static_cast<double>(traffic.size());
  state.counters["frames"] = benchmark::Counter(frames, benchmark::Counter::kIsRate);
}

void nmea2000_bus(benchmark::State& state) {
  decode(state, nmea2000_traffic(), Nmea2000::Decoder{});
}
void cia404_imu_set(benchmark::State& state) { decode(state, imu_traffic(), Cia404Imu::Decoder{}); }
void xsens_sample(benchmark::State& state) { decode(state, xsens_traffic(), Xsens::Decoder{}); }

/// The description beside the codec written by hand, on the same frames.
void described_xsens_sample(benchmark::State& state) {
  const auto found = drydock::rig_config::find_description("xsens-dbc.toml", "").value();
  described::FrameDecoder decoder(found);
  described::Record record;
  const auto traffic = xsens_traffic();
  for (auto _ : state)
    for (const CanFrame& frame : traffic) benchmark::DoNotOptimize(decoder.take(frame, record));
  const auto frames = static_cast<double>(state.iterations()) * static_cast<double>(traffic.size());
  state.counters["frames"] = benchmark::Counter(frames, benchmark::Counter::kIsRate);
}

BENCHMARK(nmea2000_bus);
BENCHMARK(cia404_imu_set);
BENCHMARK(xsens_sample);
BENCHMARK(described_xsens_sample);

}  // namespace

BENCHMARK_MAIN();
