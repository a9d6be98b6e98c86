#include <fcntl.h>

#include <ctime>

#include "drivers/link/descriptor.hpp"
#include "drivers/link/serial/line_settings.hpp"

#include "tests/hil/survive/bench.hpp"

/// A serial port disappears and comes back, in real time.
namespace drydock::fault::testing {
namespace port_test {

namespace fs = std::filesystem;

class Port : public ::testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(OfALink, Port,
                         ::testing::Values("pty:survive-log?baud=38400",
                                           "memory:survive-log?baud=38400",
                                           "tcp:127.0.0.1:46161?emulated=1"),
                         [](const auto& one) {
                           return std::string(link::parse_uri(one.param)->text).substr(0, 3);
                         });

TEST_P(Port, UnpluggedAndPluggedInAgainItStreamsWithoutHelp) {
  Bench bench(speed_log(GetParam()));
  ASSERT_TRUE(bench.reaches(State::streaming));
  bench.set(fault_of("log", FaultKind::unplug, 0.4));
  ASSERT_TRUE(bench.reaches(State::backing_off));
  ASSERT_TRUE(bench.reaches(State::streaming));
  ASSERT_TRUE(bench.hears_again());
  EXPECT_GE(bench.health().reopened, 1u);  // a TCP connection opens before it is refused
}

TEST_P(Port, UnpluggedUntilClearedStaysAway) {
  Bench bench(speed_log(GetParam()));
  ASSERT_TRUE(bench.reaches(State::streaming));
  bench.set(fault_of("log", FaultKind::unplug));
  ASSERT_TRUE(bench.reaches(State::backing_off));
  const auto before = bench.messages;
  bench.pass(800ms);
  EXPECT_EQ(bench.messages, before);
  bench.clear();
  ASSERT_TRUE(bench.reaches(State::streaming));
}

TEST_P(Port, ThatHangsUpOnceIsOpenedAgain) {
  Bench bench(speed_log(GetParam()));
  ASSERT_TRUE(bench.reaches(State::streaming));
  bench.set(fault_of("log", FaultKind::eof));
  ASSERT_TRUE(bench.reaches(State::backing_off));
  ASSERT_TRUE(bench.reaches(State::streaming));
  ASSERT_TRUE(bench.hears_again());
  EXPECT_EQ(bench.health().reopened, 1u);
}

TEST_P(Port, ThatHangsIsSilentAndComesBackWhenItEnds) {
  Bench bench(speed_log(GetParam()));
  ASSERT_TRUE(bench.reaches(State::streaming));
  bench.set(fault_of("log", FaultKind::hang, 0.8));
  ASSERT_TRUE(bench.reaches(State::stale));
  ASSERT_TRUE(bench.reaches(State::streaming));
  EXPECT_EQ(bench.health().reopened, 0u);
}

TEST(Pty, GoesFromItsFolderWhileUnpluggedAndComesBackAsAnotherNode) {
  const std::string path = link::pty_path("survive-node");
  Bench bench(speed_log("pty:survive-node?baud=38400"));
  ASSERT_TRUE(bench.reaches(State::streaming));
  ASSERT_TRUE(fs::is_symlink(path));
  bench.set(fault_of("log", FaultKind::unplug, 0.3));
  ASSERT_TRUE(bench.reaches(State::backing_off));
  EXPECT_FALSE(fs::is_symlink(path));
  ASSERT_TRUE(bench.until([&] { return fs::is_symlink(path); }));
  ASSERT_TRUE(bench.reaches(State::streaming));
}

// The driver tries a missing port at the back-off's pace: 0.25, 0.5, 1 s. A busy loop would open
// it, or read its end of file, many thousand times and use a whole processor.
TEST(Pty, ThatVanishedCostsAlmostNothing) {
  Bench bench(speed_log("pty:survive-gone?baud=38400"));
  ASSERT_TRUE(bench.reaches(State::streaming));
  bench.set(fault_of("log", FaultKind::unplug));
  ASSERT_TRUE(bench.reaches(State::backing_off));
  const std::clock_t before = std::clock();
  const auto opened_before = bench.times_in(State::opening);
  bench.pass(2s);
  const double busy_ms = 1e3 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
  RecordProperty("busy_ms", std::to_string(busy_ms));
  EXPECT_LE(bench.times_in(State::opening) - opened_before, 4u);
  EXPECT_LT(busy_ms, 100);  // about 2 on a quiet machine
}

TEST(ById, TheNameIsFollowedToAnotherNodeAtTheNextOpening) {
  const link::testing::Folder folder;
  const std::string by_id = folder.file("usb-FTDI_survive-if00-port0");
  boost::asio::io_context io;
  const auto plug_in = [&](const std::string& name) {
    fs::remove(by_id);
    auto port = link::testing::open(io, "pty:" + folder.file(name), link::Side::device);
    fs::create_symlink(fs::read_symlink(folder.file(name)), by_id);
    return port;
  };
  struct Silent final : device::Listener {
    void on_measurement(const measurement::Measurement&) override { ++messages; }
    void on_state(const device::Device&, const device::Transition&) override {}
    int messages = 0;
  } listener;
  rig_config::Rig rig;
  rig.devices = {speed_log("serial:" + by_id + "?baud=38400")};
  const std::string sentence = "$HCVHW,,,,,0.2,N,0,K*5B\r\n";

  auto port = plug_in("ttyUSB0");
  shell::RealTime drivers(io, *shell::make_devices(rig), listener);
  drivers.start();
  const auto reaches = [&](State state) {
    return link::testing::run_until(
        io, [&] { return drivers.device(0).state() == state; }, 10s);
  };
  ASSERT_TRUE(reaches(State::waiting));
  ASSERT_TRUE(link::testing::run(io, port->write(link::testing::bytes(sentence))));
  ASSERT_TRUE(reaches(State::streaming));

  port->close();
  ASSERT_TRUE(reaches(State::backing_off));
  const auto other = plug_in("ttyUSB1");
  ASSERT_TRUE(reaches(State::waiting));
  ASSERT_TRUE(link::testing::run(io, other->write(link::testing::bytes(sentence))));
  ASSERT_TRUE(reaches(State::streaming));
  EXPECT_EQ(listener.messages, 2);
  drivers.stop();
  other->close();
  io.restart();
  io.run_for(5s);
  EXPECT_TRUE(io.stopped());
}

// The kernel knows the rate at which the driver opened the line. At any other rate the device sends
// only noise.
TEST(Baud, WrittenAsAutoIsFoundAndFoundAgainWhenTheDeviceChangesIt) {
  const link::testing::Folder folder;
  boost::asio::io_context io;
  const auto port = link::testing::open(io, "pty:" + folder.file("tty"), link::Side::device);
  struct Heard final : device::Listener {
    void on_measurement(const measurement::Measurement& m) override {
      ++messages;
      last = measurement::origin_of(m);
    }
    void on_state(const device::Device&, const device::Transition&) override {}
    int messages = 0;
    measurement::Origin last;
  } listener;
  rig_config::Rig rig;
  rig.devices = {speed_log("serial:" + folder.file("tty") + "?baud=auto&emulated=1")};
  rig.devices[0].stale_after_s = 0.4;
  shell::RealTime drivers(io, *shell::make_devices(rig), listener);
  drivers.start();

  const std::string sentence = "$HCVHW,,,,,0.2,N,0,K*5B\r\n";
  unsigned device_baud = 9600;
  const link::Descriptor line(::open(folder.file("tty").c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
  const auto hear = [&](int messages) {
    const auto end = std::chrono::steady_clock::now() + 30s;
    const int before = listener.messages;
    while (listener.messages < before + messages && std::chrono::steady_clock::now() < end) {
      const bool same = link::line_baud(line.get()).value() == device_baud;
      const auto said = same ? sentence : std::string(sentence.size(), '\x9A');
      EXPECT_TRUE(link::testing::run(io, port->write(link::testing::bytes(said))));
      link::testing::run_until(
          io, [] { return false; }, 50ms);
    }
    return listener.messages >= before + messages;
  };
  ASSERT_TRUE(hear(3));
  EXPECT_EQ(link::line_baud(line.get()).value(), 9600u);
  // 25 bytes of ten bits: the time on the line must fit the rate that was found.
  EXPECT_NEAR(measurement::seconds(listener.last.received_at - listener.last.valid_at),
              250.0 / 9600, 1e-6);
  device_baud = 4800;
  ASSERT_TRUE(hear(3));
  EXPECT_EQ(link::line_baud(line.get()).value(), 4800u);
  drivers.stop();
  port->close();
  io.restart();
  io.run_for(5s);
  EXPECT_TRUE(io.stopped());
}

TEST(FaultsInRealTime, ReachTheBytesOfALineAndLeaveThem) {
  Bench bench(speed_log("memory:survive-bytes?baud=38400"));
  ASSERT_TRUE(bench.reaches(State::streaming));
  FaultConfig wrong = fault_of("log", FaultKind::bad_checksum, 0.5);
  wrong.probability = 1;
  bench.set(wrong);
  ASSERT_TRUE(bench.until([&] { return bench.health().stream.bad_checksums >= 2; }));
  ASSERT_TRUE(bench.hears_again());
  EXPECT_TRUE(bench.injector.in_force(link::steady_now()).empty());
}

TEST(FaultsInRealTime, AreRefusedWhereTheDeviceIsNotPlayedHere) {
  rig_config::Rig rig;
  rig.devices = {speed_log("serial:/dev/ttyUSB0?baud=38400")};
  rig.faults = {fault_of("log", FaultKind::drop)};
  const auto problems = check_faults(rig);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].what,
            "device \"log\" is not emulated, its link is serial:/dev/ttyUSB0?baud=38400; allowed: "
            "drydock proxy");
  rig.devices = {speed_log("udp:127.0.0.1:4001?emulated=1")};
  rig.faults = {fault_of("log", FaultKind::unplug)};
  ASSERT_EQ(check_faults(rig).size(), 1u);
  EXPECT_NE(check_faults(rig)[0].what.find("allowed: hang, off"), std::string::npos);
}

}  // namespace port_test
}  // namespace drydock::fault::testing
