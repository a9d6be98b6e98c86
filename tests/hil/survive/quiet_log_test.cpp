#include "drivers/shell/device_actor.hpp"
#include "drivers/shell/lockstep.hpp"
#include "hil/emulate/lockstep.hpp"
#include "tests/hil/survive/bench.hpp"

/// What a person reads while a fault comes and goes, in virtual time.
namespace drydock::fault::testing {
namespace quiet_log_test {

struct Log final : device::Listener {
  void on_measurement(const measurement::Measurement& m) override {
    last_message = measurement::origin_of(m).received_at;
  }
  void on_state(const device::Device&, const device::Transition& change) override {
    changes.push_back(change);
  }
  std::vector<device::Transition> changes;
  measurement::Stamp last_message{};
};

struct ToDevice final : device::Transmitter {
  void send(wire::Bytes) override {}
  void send(const wire::CanFrame&) override {}
};

class QuietLog : public ::testing::TestWithParam<FaultKind> {};

INSTANTIATE_TEST_SUITE_P(OfAFaultThatToggles, QuietLog,
                         ::testing::Values(FaultKind::unplug, FaultKind::eof, FaultKind::hang,
                                           FaultKind::off, FaultKind::drop, FaultKind::flip,
                                           FaultKind::garbage, FaultKind::bad_checksum,
                                           FaultKind::truncate),
                         [](const auto& one) {
                           std::string name(rig_config::word_of(one.param).name);
                           std::erase(name, '-');
                           return name;
                         });

// A minute in which the fault is there for two seconds of every four: a line for each change of
// state, none that says the same again, and the device streams two seconds after its last end.
TEST_P(QuietLog, HasOneLineForEachChangeOfState) {
  const auto start = measurement::stamp_from_ns(1'700'000'000'000'000'000);
  rig_config::Rig rig;
  rig.devices = {speed_log("memory:quiet?baud=38400")};
  FaultConfig fault = fault_of("log", GetParam(), 2.0);
  fault.start_s = 1;
  fault.every_s = 4;
  fault.amount[0] = 16;
  fault.file = "quiet.toml";
  rig.faults = {fault};
  const motion::KinematicTrajectory trajectory{rig_config::MissionConfig{}, start};
  Injector injector(rig, trajectory, start);
  Log log;
  ToDevice nowhere;
  shell::Lockstep clock(start);
  shell::DeviceActor actor(std::move(shell::make_devices(rig)->front()), log, nowhere, start);
  emulate::EmulatedLine line(std::move(*injector.device(rig.devices[0])), 38400,
                             [&](wire::Bytes bytes, const emulate::Passage& passage) {
                               actor.receive(bytes, passage.ended_at);
                             });
  line.set_on_port([&](bool there, measurement::Stamp at) { actor.set_port(there, at); });
  clock.add(actor);
  clock.add(line);
  clock.run_until(start + std::chrono::milliseconds{60'950});

  for (std::size_t i = 1; i < log.changes.size(); ++i) {
    EXPECT_NE(log.changes[i].from, log.changes[i].to);
    EXPECT_EQ(log.changes[i].from, log.changes[i - 1].to);
  }
  constexpr std::size_t toggles = 15, most_changes = 10;  // 250 ms, 500 ms, 1 s of back-off
  EXPECT_LE(log.changes.size(), 3 + toggles * most_changes);
  EXPECT_EQ(actor.device().state(), State::streaming);
  EXPECT_GT(log.last_message, start + std::chrono::seconds{60});
}

}  // namespace quiet_log_test
}  // namespace drydock::fault::testing
