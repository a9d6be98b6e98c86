#include "drivers/shell/device_actor.hpp"
#include "drivers/shell/lockstep.hpp"
#include "hil/emulate/lockstep.hpp"
#include "tests/hil/survive/bench.hpp"

/// The lines that a person reads while a fault comes and goes, in virtual time.
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

std::string words_of(FaultKind kind) {
  std::string name(rig_config::word_of(kind).name);
  std::erase(name, '-');
  return name;
}

class QuietLog : public ::testing::TestWithParam<FaultKind> {};

INSTANTIATE_TEST_SUITE_P(OfAFaultThatToggles, QuietLog,
                         ::testing::Values(FaultKind::unplug, FaultKind::eof, FaultKind::hang,
                                           FaultKind::off, FaultKind::drop, FaultKind::flip,
                                           FaultKind::garbage, FaultKind::bad_checksum,
                                           FaultKind::truncate),
                         [](const auto& one) { return words_of(one.param); });

/// A speed log with one fault, in virtual time.
class Watch {
 public:
  explicit Watch(FaultConfig fault) : injector_(with(std::move(fault)), trajectory_, start) {
    line_.set_on_port([&](bool there, measurement::Stamp at) { actor_.set_port(there, at); });
    clock_.add(actor_);
    clock_.add(line_);
  }
  void run_until(std::chrono::nanoseconds t) { clock_.run_until(start + t); }

  static constexpr auto start = measurement::stamp_from_ns(1'700'000'000'000'000'000);
  Log log;
  State state() const { return actor_.device().state(); }

 private:
  const rig_config::Rig& with(FaultConfig fault) {
    rig_.devices = {speed_log("memory:quiet?baud=38400")};
    fault.file = "quiet.toml";
    rig_.faults = {std::move(fault)};
    return rig_;
  }

  rig_config::Rig rig_;
  motion::KinematicTrajectory trajectory_{rig_config::MissionConfig{}, start};
  Injector injector_;
  ToDevice nowhere_;
  shell::Lockstep clock_{start};
  shell::DeviceActor actor_{std::move(shell::make_devices(rig_)->front()), log, nowhere_, start};
  emulate::EmulatedLine line_{*injector_.device(rig_.devices[0]), 38400,
                              [this](wire::Bytes bytes, const emulate::Passage& passage) {
                                actor_.receive(bytes, passage.ended_at);
                              }};
};

// For a minute the fault is in force for two seconds of every four. There is one line for each
// change of state, no line repeats the one before, and the device streams two seconds after the
// last end.
TEST_P(QuietLog, HasOneLineForEachChangeOfState) {
  FaultConfig fault = fault_of("log", GetParam(), 2.0);
  fault.start_s = 1;
  fault.every_s = 4;
  fault.amount[0] = 16;
  Watch watch(fault);
  watch.run_until(60'950ms);

  const auto& changes = watch.log.changes;
  for (std::size_t i = 1; i < changes.size(); ++i) {
    EXPECT_NE(changes[i].from, changes[i].to);
    EXPECT_EQ(changes[i].from, changes[i - 1].to);
  }
  constexpr std::size_t toggles = 15, most_changes = 5;  // backing off for two reasons, opening,
                                                         // waiting, streaming
  EXPECT_LE(changes.size(), 3 + toggles * most_changes);
  EXPECT_EQ(watch.state(), State::streaming);
  EXPECT_GT(watch.log.last_message, watch.start + 60s);
}

class LongAbsence : public ::testing::TestWithParam<FaultKind> {};

INSTANTIATE_TEST_SUITE_P(OfADevice, LongAbsence,
                         ::testing::Values(FaultKind::unplug, FaultKind::hang, FaultKind::off,
                                           FaultKind::bad_checksum),
                         [](const auto& one) { return words_of(one.param); });

TEST_P(LongAbsence, OfTenMinutesTakesAFewLinesAndEndsWithinTwoSeconds) {
  FaultConfig fault = fault_of("log", GetParam(), 600.0);
  fault.start_s = 5;
  fault.probability = 1;
  Watch watch(fault);
  watch.run_until(604s);
  EXPECT_NE(watch.state(), State::streaming);
  watch.run_until(607s);
  EXPECT_EQ(watch.state(), State::streaming);
  const auto& changes = watch.log.changes;
  EXPECT_EQ(changes.back().to, State::streaming);
  EXPECT_LE(changes.back().at, watch.start + 607s);
  // Opening, waiting, streaming; then once each: stale, backing off for two reasons, opening,
  // waiting, streaming.
  EXPECT_LE(changes.size(), 9U);
}

// For example a TCP server without room: the port opens, and the other end closes it at once.
TEST(QuietDevice, ThatIsHungUpOnForTenMinutesSaysItOnce) {
  Log log;
  ToDevice nowhere;
  const auto start = Watch::start;
  rig_config::Rig rig;
  rig.devices = {speed_log("memory:busy?baud=38400")};
  const auto device = std::move(shell::make_devices(rig)->front());
  device->connect(log, nowhere);
  device->start(start);
  for (auto now = start; now < start + 600s; now = device->deadline().value_or(now)) {
    device->tick(now);
    if (!device->wants_open()) continue;
    device->opened(now, measurement::Provenance::emulated);
    device->link_lost(now, "link lost: End of file");
  }
  EXPECT_EQ(log.changes.size(), 4U);  // opening, waiting, backing off, opening again
}

TEST(QuietDevice, OfAnUnknownRateOnADeadPortIsInOneStateWithOneLine) {
  Log log;
  ToDevice nowhere;
  const auto start = Watch::start;
  rig_config::Rig rig;
  rig.devices = {speed_log("serial:/dev/ttyUSB0?baud=auto")};
  shell::DeviceActor actor(std::move(shell::make_devices(rig)->front()), log, nowhere, start);
  shell::Lockstep clock(start);
  clock.add(actor);
  clock.run_until(start + 599s);
  ASSERT_EQ(log.changes.size(), 2U);
  EXPECT_EQ(log.changes[0].to, State::opening);
  EXPECT_EQ(log.changes[1].to, State::waiting);
  EXPECT_EQ(log.changes[1].why.view(), "link open; its rate is searched until the first message");
  const auto health = actor.device().health(start + 599s);
  EXPECT_EQ(health.status.view(), "no message for 599 s; its rate is searched");
  EXPECT_EQ(health.reopened, 299U) << "each rate for two seconds";
}

}  // namespace quiet_log_test
}  // namespace drydock::fault::testing
