// Latency from wire to estimate at the rate of a real IMU. The same run measures the cost of the
// host itself: a bare pty round trip and a bare DDS hop.
#include <benchmark/benchmark.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "drivers/bus/participant.hpp"
#include "drivers/bus/publisher.hpp"
#include "drivers/bus/subscriber.hpp"
#include "drivers/host/driver_host.hpp"
#include "drivers/host/rig_bus.hpp"
#include "drivers/host/rig_publisher.hpp"
#include "drivers/link/link.hpp"
#include "drivers/shell/rig_devices.hpp"
#include "drivers/wire/can/slcan.hpp"
#include "drivers/wire/canopen/cia404_imu.hpp"
#include "estimators/host/estimator_host.hpp"
#include "estimators/setup/rig_pipeline.hpp"
#include "tests/bench/percentiles.hpp"
#include "tests/bench/raw_pty.hpp"

namespace {

using namespace drydock;
using bench::Pty;
using bench::wait_readable;
using Clock = std::chrono::steady_clock;
using Microseconds = std::chrono::duration<double, std::micro>;

constexpr int samples = 1000;
constexpr auto period = std::chrono::milliseconds{10};  // 100 Hz, so that the CPU idles in between
constexpr int domain = 77;

/// The time at which something arrived on another thread. Waiting blocks, as in a program, and does
/// not spin.
class Arrival {
 public:
  Arrival() : fd_(eventfd(0, EFD_CLOEXEC)) {}
  ~Arrival() { close(fd_); }
  Arrival(const Arrival&) = delete;
  Arrival& operator=(const Arrival&) = delete;

  void note() {
    at_ns_ = Clock::now().time_since_epoch().count();
    const std::uint64_t one = 1;
    if (write(fd_, &one, sizeof one) != sizeof one) std::abort();
  }
  /// Microseconds since `start`. Empty after a second without an arrival.
  std::optional<double> wait_since(Clock::time_point start) {
    std::uint64_t count = 0;
    if (!wait_readable(fd_, 1000) || read(fd_, &count, sizeof count) != sizeof count) return {};
    return static_cast<double>(at_ns_ - start.time_since_epoch().count()) * 1e-3;
  }

 private:
  int fd_;
  std::atomic<std::int64_t> at_ns_{0};
};

/// Notes the arrival of each estimate.
class EachEstimate final : public host::Follower {
 public:
  explicit EachEstimate(Arrival& arrival) : arrival_(arrival) {}
  void on_estimate(const host::Estimate&) override { arrival_.note(); }

 private:
  Arrival& arrival_;
};

void report(benchmark::State& state, std::vector<double> us) {
  if (us.empty()) return state.SkipWithError("nothing came through");
  state.counters["n"] = static_cast<double>(us.size());
  const auto [p50, p99] = bench::percentiles_of(std::move(us));
  state.counters["p50_us"] = p50;
  state.counters["p99_us"] = p99;
}

void bare_pty_round_trip(benchmark::State& state) {
  Pty pty;
  std::atomic<bool> done{false};
  std::jthread echo([&] {
    char buffer[256];
    while (!done) {
      if (!wait_readable(pty.slave, 20)) continue;
      const auto n = read(pty.slave, buffer, sizeof buffer);
      if (n > 0 && write(pty.slave, buffer, static_cast<std::size_t>(n)) != n) std::abort();
    }
  });
  std::vector<double> us;
  for (auto _ : state) {
    std::this_thread::sleep_for(period);
    char out[64] = {}, in[256];
    const auto start = Clock::now();
    if (write(pty.master, out, sizeof out) != sizeof out) std::abort();
    std::size_t got = 0;
    while (got < sizeof out && wait_readable(pty.master, 1000)) {
      const auto n = read(pty.master, in, sizeof in);
      if (n > 0) got += static_cast<std::size_t>(n);
    }
    us.push_back(Microseconds(Clock::now() - start).count());
    state.SetIterationTime(us.back() * 1e-6);
  }
  done = true;
  report(state, us);
}

void bare_dds_hop(benchmark::State& state) {
  const bus::Participant participant(domain);
  const std::vector<bus::Device> devices{{.name = "imu", .kind = bus::Kind::imu}};
  host::RigPublisher publisher(participant, devices);
  bus::Subscriber subscriber(participant, devices);
  Arrival arrival;
  std::atomic<bool> done{false};
  std::jthread reader([&] {
    while (!done) {
      if (!wait_readable(subscriber.fd(), 20)) continue;
      subscriber.take_measurements([&](const measurement::Measurement&) { arrival.note(); });
    }
  });
  while (subscriber.matched_writers() == 0) std::this_thread::sleep_for(period);
  std::vector<double> us;
  measurement::ImuSample sample;
  for (auto _ : state) {
    std::this_thread::sleep_for(period);
    const auto start = Clock::now();
    publisher.on_measurement(sample);
    const auto taken = arrival.wait_since(start);
    if (taken) us.push_back(*taken);
    state.SetIterationTime(taken.value_or(0) * 1e-6);
  }
  done = true;
  report(state, us);
}

/// The three TPDOs of one IMU sample at rest, as slcan text.
std::string imu_sample_text() {
  wire::cia404_imu::ImuSet at_rest;
  at_rest.node = 1;
  at_rest.rate_radps = {0, 0, 0};
  at_rest.specific_force_mps2 = {0, 0, -9.8};
  std::string text;
  for (const auto& frame : wire::cia404_imu::encode(at_rest)) {
    std::array<std::uint8_t, 64> line{};
    const auto n = wire::slcan::encode(wire::slcan::Frame{frame, {}}, line);
    text.append(reinterpret_cast<const char*>(line.data()), n);
  }
  return text;
}

rig_config::Rig imu_rig(const std::string& tty) {
  rig_config::Rig rig;
  rig.dds_domain = domain + 1;
  rig.reorder_window_s = 0;
  rig_config::DeviceConfig imu;
  imu.name = "imu";
  imu.kind = rig_config::DeviceKind::imu;
  imu.protocol = "cia404-imu";
  imu.link = "slcan:" + tty;
  imu.rate_hz = 100;
  rig.devices.push_back(imu);
  rig_config::EstimatorConfig leveling;
  leveling.name = "leveling";
  leveling.imu = "imu";
  leveling.kind = rig_config::LevelingConfig{.stationary = true, .log = {}, .start = {}};
  rig.estimators.push_back(leveling);
  return rig;
}

void wire_to_estimate(benchmark::State& state) {
  Pty pty;
  const auto rig = imu_rig(pty.name);
  boost::asio::io_context io{1};
  const bus::Participant participant(static_cast<std::uint32_t>(rig.dds_domain));
  host::RigPublisher publisher(participant, host::bus_devices(rig), host::estimator_names(rig));
  bus::Subscriber subscriber(participant, host::bus_devices(rig));
  Arrival published;
  EachEstimate each_estimate(published);
  host::Followers followers;
  followers.add(publisher);
  followers.add(each_estimate);
  host::EstimatorHost estimators(io, setup::pipeline_options(rig), subscriber, followers);
  auto devices = shell::make_devices(rig);
  if (!devices) return state.SkipWithError(devices.error().message.c_str());
  host::DriverHost drivers(io, std::move(*devices), followers);
  estimators.start();
  drivers.start();
  std::jthread shell([&] { io.run(); });

  const std::string text = imu_sample_text();
  const auto drain = [&] {  // commands of the slcan link to its adapter
    char heard[512];
    while (wait_readable(pty.master, 0) && read(pty.master, heard, sizeof heard) > 0) {
    }
  };
  const auto send = [&] {
    const auto n = static_cast<std::ptrdiff_t>(text.size());
    if (write(pty.master, text.data(), text.size()) != n) std::abort();
  };
  for (int i = 0; i < 50; ++i) {  // the link opens, the filter starts
    std::this_thread::sleep_for(period);
    drain();
    send();
    published.wait_since(Clock::now());
  }
  std::vector<double> us;
  for (auto _ : state) {
    std::this_thread::sleep_for(period);
    drain();
    const auto start = Clock::now();
    send();
    const auto taken = published.wait_since(start);
    if (taken) us.push_back(*taken);
    state.SetIterationTime(taken.value_or(0) * 1e-6);
  }
  boost::asio::post(io, [&] {
    drivers.stop();
    estimators.stop();
  });
  shell.join();
  report(state, us);
}

}  // namespace

BENCHMARK(bare_pty_round_trip)->Iterations(samples)->UseManualTime()->Unit(benchmark::kMicrosecond);
BENCHMARK(bare_dds_hop)->Iterations(samples)->UseManualTime()->Unit(benchmark::kMicrosecond);
BENCHMARK(wire_to_estimate)->Iterations(samples)->UseManualTime()->Unit(benchmark::kMicrosecond);

BENCHMARK_MAIN();
