#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "drivers/link/clock.hpp"
#include "drivers/shell/real_time.hpp"
#include "drivers/shell/rig_devices.hpp"
#include "hil/emulate/real_time/real_time.hpp"
#include "hil/fault/injector.hpp"
#include "hil/motion/kinematic_trajectory.hpp"
#include "rig_config/fault_vocabulary.hpp"
#include "tests/drivers/link/running.hpp"

/// Drivers and emulated devices over real links. Tests set the faults by hand.
namespace drydock::fault::testing {

using device::State;
using namespace std::chrono_literals;

inline rig_config::DeviceConfig speed_log(const std::string& link) {
  rig_config::DeviceConfig config;
  config.name = "log";
  config.kind = rig_config::DeviceKind::emlog;
  config.protocol = "nmea0183";
  config.link = link;
  config.rate_hz = 10;
  return config;
}

inline rig_config::DeviceConfig bus_depth(const std::string& link) {
  rig_config::DeviceConfig config = speed_log(link);
  config.name = "depth";
  config.kind = rig_config::DeviceKind::depth;
  config.protocol = "nmea2000";
  return config;
}

inline FaultConfig fault_of(const std::string& device, FaultKind kind,
                            std::optional<double> for_s = {}) {
  FaultConfig fault;
  fault.device = device;
  fault.kind = kind;
  fault.for_s = for_s;
  fault.words = device + ": " + std::string(rig_config::word_of(kind).name);
  return fault;
}

/// The other end of the link is the test's own.
inline const std::vector<rig_config::DeviceConfig> nobody;

class Bench : private device::Listener {
 public:
  /// Both ends of one link. Silence for 0.4 s makes the device stale.
  explicit Bench(const rig_config::DeviceConfig& config)
      : Bench(quickly_stale(config), quickly_stale(config)) {}
  /// The driver's end and the emulated device's end of a line with two names.
  Bench(const rig_config::DeviceConfig& driver, const rig_config::DeviceConfig& emulated)
      : Bench(driver, std::vector{emulated}) {}
  Bench(const rig_config::DeviceConfig& driver,
        const std::vector<rig_config::DeviceConfig>& emulated)
      : rig_(rig_of(driver)),
        drivers_(io, *shell::make_devices(rig_), *this),
        emulator_(io, injector) {
    auto started = emulator_.start(emulated);
    if (!started) ADD_FAILURE() << started.error().message;
    drivers_.start();
  }
  ~Bench() override {
    drivers_.stop();
    emulator_.stop();
    io.restart();
    io.run_for(5s);
    EXPECT_TRUE(io.stopped()) << "a coroutine is still waiting";
  }

  void set(const FaultConfig& fault) {
    const auto done = injector.set(fault, link::steady_now());
    EXPECT_TRUE(done) << (done ? "" : done.error().front().what);
    emulator_.wake();
  }
  void clear() {
    injector.clear("", {});
    emulator_.wake();
  }
  template <class Done>
  bool until(Done&& done) {
    return link::testing::run_until(io, done, 10s);
  }
  bool reaches(State state) {
    return until([&] { return drivers_.device(0).state() == state; });
  }
  void pass(std::chrono::milliseconds time) {
    link::testing::run_until(
        io, [] { return false; }, time);
  }
  /// True after new measurements, not one that was already on its way.
  bool hears_again() {
    const auto before = messages;
    return until([&] { return messages >= before + 2; });
  }
  device::Health health() const { return drivers_.health(0); }
  std::size_t times_in(State state) const {
    return static_cast<std::size_t>(std::ranges::count(states, state));
  }

  boost::asio::io_context io;
  std::uint64_t messages = 0;
  std::vector<measurement::Measurement> heard;
  std::vector<State> states;
  std::vector<std::string> lines;

 private:
  static rig_config::DeviceConfig quickly_stale(rig_config::DeviceConfig config) {
    config.stale_after_s = 0.4;
    return config;
  }
  static rig_config::Rig rig_of(const rig_config::DeviceConfig& config) {
    rig_config::Rig rig;
    rig.devices = {config};
    return rig;
  }
  void on_measurement(const measurement::Measurement& m) override {
    ++messages;
    heard.push_back(m);
  }
  void on_state(const device::Device&, const device::Transition& change) override {
    states.push_back(change.to);
    lines.emplace_back(change.why.view());
  }

  rig_config::Rig rig_;
  motion::KinematicTrajectory trajectory_{rig_config::MissionConfig{}, link::steady_now()};

 public:
  Injector injector{rig_, trajectory_, trajectory_.start()};

 private:
  shell::RealTime drivers_;
  emulate::RealTimeEmulator emulator_;
};

/// On a CAN link of any kind: the drivers are told when the controller goes bus-off, and when it
/// restarts a second later.
inline void expect_bus_off_told(const std::string& link) {
  Bench bench(bus_depth(link));
  ASSERT_TRUE(bench.reaches(State::streaming));
  bench.set(fault_of("depth", FaultKind::bus_off, 1.0));
  ASSERT_TRUE(bench.reaches(State::stale));
  EXPECT_NE(std::string(bench.health().last_error.view()).find("bus-off"), std::string::npos);
  ASSERT_TRUE(bench.reaches(State::streaming));
  EXPECT_TRUE(bench.until([&] { return bench.health().error_frames == 2; }));  // restarted
}

}  // namespace drydock::fault::testing
