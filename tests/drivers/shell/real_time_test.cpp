#include "drivers/shell/real_time.hpp"

#include <fstream>

#include "tests/drivers/link/scripted_adapter.hpp"

/// Real links in real time: these tests check the interaction with the operating system.
namespace drydock::shell {
namespace {

using device::DeviceOptions;
using device::Kind;
using device::State;
using link::Side;
using link::testing::run;
using link::testing::run_until;
using namespace std::chrono_literals;

struct Log final : device::Listener, RawListener {
  void on_measurement(const measurement::Measurement& m) override {
    origins.push_back(measurement::origin_of(m));
  }
  void on_state(const device::Device&, const device::Transition& change) override {
    states.push_back(change.to);
    reasons.emplace_back(change.why.view());
  }
  void on_bytes(std::string_view, Direction direction, wire::Bytes bytes, Stamp) override {
    if (direction == Direction::received) {
      raw_received.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    }
  }
  void on_frame(std::string_view link, Direction direction, const wire::CanFrame& frame,
                Stamp) override {
    raw_link = link;
    (direction == Direction::sent ? frames_sent : frames_received).push_back(frame);
  }

  std::vector<measurement::Origin> origins;
  std::vector<State> states;
  std::vector<std::string> reasons;
  std::string raw_received, raw_link;
  std::vector<wire::CanFrame> frames_sent, frames_received;
};

std::unique_ptr<device::Device> make_device(Kind kind, const std::string& protocol,
                                            const std::string& uri, std::uint16_t index = 0,
                                            std::uint8_t address = 0) {
  DeviceOptions options;
  options.link = uri;
  options.driver.kind = kind;
  options.driver.protocol = protocol;
  options.driver.device = index;
  options.driver.address = address;
  options.life_cycle.stale_after = 200ms;
  options.life_cycle.reopen_after = 200ms;
  options.life_cycle.first_back_off = 20ms;
  return *device::Device::make(options);
}

template <class... Device>
std::vector<std::unique_ptr<device::Device>> list(Device... device) {
  std::vector<std::unique_ptr<device::Device>> devices;
  (devices.push_back(std::move(device)), ...);
  return devices;
}

const std::string vhw = "$HCVHW,,,,,0.2,N,0,K*5B\r\n";

wire::Bytes bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

wire::CanFrame frame_of(std::uint32_t id, std::initializer_list<std::uint8_t> data) {
  wire::CanFrame frame;
  frame.id = id;
  frame.extended = id > 0x7FF;
  for (const auto byte : data) frame.data[frame.size++] = byte;
  return frame;
}

class RealTimeOnALine : public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<link::ByteLink> plug_in() {
    auto opened = link::open_bytes(io.get_executor(), *link::parse_uri(GetParam()), Side::device);
    EXPECT_TRUE(opened) << opened.error().message;
    return opened ? std::move(*opened) : nullptr;
  }
  bool in_state(const RealTime& shell, State state) {
    return run_until(io, [&] { return shell.device(0).state() == state; });
  }
  void end(RealTime& shell) {
    shell.stop();
    io.restart();
    io.run_for(5s);  // returns as soon as every coroutine has ended
    EXPECT_TRUE(io.stopped()) << "a coroutine is still waiting";
  }

  boost::asio::io_context io;
  Log log;
};

TEST_P(RealTimeOnALine, StreamsAndComesBackAfterTheDeviceWasUnplugged) {
  auto plugged = plug_in();
  ASSERT_TRUE(plugged);
  RealTime shell(io, list(make_device(Kind::emlog, "nmea0183", GetParam())), log, &log);
  shell.start();
  ASSERT_TRUE(in_state(shell, State::waiting));
  ASSERT_TRUE(run(io, plugged->write(bytes_of(vhw))));
  ASSERT_TRUE(in_state(shell, State::streaming));

  plugged->close();
  plugged.reset();
  ASSERT_TRUE(in_state(shell, State::backing_off));
  plugged = plug_in();
  ASSERT_TRUE(plugged);
  ASSERT_TRUE(in_state(shell, State::waiting));
  ASSERT_TRUE(run(io, plugged->write(bytes_of(vhw))));
  ASSERT_TRUE(in_state(shell, State::streaming));

  EXPECT_EQ(log.origins.size(), 2U);
  EXPECT_EQ(log.origins[0].provenance, measurement::Provenance::emulated);
  EXPECT_EQ(log.raw_received, vhw + vhw);
  EXPECT_EQ(shell.health(0).reopened, 1U);
  EXPECT_FALSE(shell.health(0).last_error.empty());
  end(shell);
  EXPECT_EQ(log.states.back(), State::closed);
}

TEST_P(RealTimeOnALine, WaitsForADeviceThatIsNotThereYet) {
  RealTime shell(io, list(make_device(Kind::emlog, "nmea0183", GetParam())), log);
  shell.start();
  ASSERT_TRUE(in_state(shell, State::backing_off));
  auto plugged = plug_in();
  ASSERT_TRUE(in_state(shell, State::waiting));
  EXPECT_NE(log.reasons.at(1).find("; retry in 0.02 s"), std::string::npos) << log.reasons.at(1);
  end(shell);
}

TEST_P(RealTimeOnALine, QuietLineGoesStaleAndIsOpenedAgain) {
  auto plugged = plug_in();
  RealTime shell(io, list(make_device(Kind::emlog, "nmea0183", GetParam())), log);
  shell.start();
  ASSERT_TRUE(in_state(shell, State::waiting));
  ASSERT_TRUE(run(io, plugged->write(bytes_of(vhw))));
  ASSERT_TRUE(in_state(shell, State::stale));
  ASSERT_TRUE(in_state(shell, State::waiting));
  EXPECT_EQ(shell.health(0).reopened, 1U);
  end(shell);
}

INSTANTIATE_TEST_SUITE_P(Lines, RealTimeOnALine,
                         testing::Values("memory:shell-log", "pty:shell-log?baud=4800"),
                         [](const auto& param_info) {
                           return param_info.param.substr(0, param_info.param.find(':'));
                         });

class RealTimeOnABus : public testing::Test {
 protected:
  std::unique_ptr<link::FrameLink> plug_in() {
    auto opened = link::open_frames(io.get_executor(), *link::parse_uri(uri), Side::device);
    EXPECT_TRUE(opened) << opened.error().message;
    return opened ? std::move(*opened) : nullptr;
  }

  const std::string uri = "memory-can:shell-bus";
  const wire::CanFrame pressure = frame_of(0x15FD0A23, {0, 0, 1, 0x42, 0xB8, 0x1E, 0x00, 0xFF});
  const wire::CanFrame rudder = frame_of(0x09F10D11, {0, 0xF8, 0xFF, 0x7F, 0xD0, 7, 0xFF, 0xFF});
  boost::asio::io_context io;
  Log log;
};

TEST_F(RealTimeOnABus, DevicesShareOneLinkAndEachPicksItsOwn) {
  auto bus = plug_in();
  auto depth = make_device(Kind::depth, "nmea2000", uri, 0);
  auto actuators = make_device(Kind::actuator, "nmea2000", uri, 1);
  RealTime shell(io, list(std::move(depth), std::move(actuators)), log, &log);
  shell.start();
  ASSERT_TRUE(run_until(io, [&] { return shell.device(1).state() == State::waiting; }));
  ASSERT_TRUE(run(io, bus->write(pressure)));
  ASSERT_TRUE(run(io, bus->write(rudder)));
  ASSERT_TRUE(run_until(io, [&] { return log.origins.size() == 2; }));
  EXPECT_EQ(log.origins[0].device, 0);
  EXPECT_EQ(log.origins[1].device, 1);
  EXPECT_EQ(log.raw_link, uri);
  EXPECT_EQ(log.frames_received, (std::vector{pressure, rudder}));  // each once: one link
  shell.stop();
  io.restart();
  io.run_for(5s);
  EXPECT_TRUE(io.stopped());
}

TEST_F(RealTimeOnABus, RepliesReachTheBusAndTheTap) {
  auto bus = plug_in();
  RealTime shell(io, list(make_device(Kind::imu, "cia404-imu", uri, 0, 5)), log, &log);
  shell.start();
  const auto received = run(io, bus->read());
  ASSERT_TRUE(received);
  const wire::CanFrame start_5 = frame_of(0x000, {0x01, 0x05});
  EXPECT_EQ(received->frame, start_5);
  ASSERT_TRUE(run_until(io, [&] { return !log.frames_sent.empty(); }));
  EXPECT_EQ(log.frames_sent, std::vector{start_5});
  shell.stop();
  io.restart();
  io.run_for(5s);
}

TEST(RealTimeOnARecording, EndOfTheRecordingIsTheEndNotAFault) {
  link::testing::Folder folder;
  const std::string path = folder.file("log.nmea");
  std::ofstream(path) << vhw << vhw << vhw;
  boost::asio::io_context io;
  Log log;
  RealTime shell(io, list(make_device(Kind::emlog, "nmea0183", "file:" + path + "?speed=max")),
                 log);
  shell.start();
  ASSERT_TRUE(
      run_until(io, [&] { return !log.states.empty() && log.states.back() == State::closed; }));
  EXPECT_EQ(log.origins.size(), 3U);
  EXPECT_EQ(log.origins.at(0).provenance, measurement::Provenance::replayed);
  EXPECT_EQ(log.reasons.back(), "end of the recording");
  const device::Health health = shell.health(0);
  EXPECT_EQ(health.stream.bytes_in,
            health.stream.bytes_good + health.stream.bytes_skipped + health.held_bytes);
  shell.stop();
  io.restart();
  io.run_for(5s);
  EXPECT_TRUE(io.stopped());
}

TEST(RealTimeListening, DevicesThatOnlyListenOpenAnSlcanAdapterThatOnlyListens) {
  const link::testing::Folder folder;
  const std::string pty = "pty:" + folder.file("can");
  boost::asio::io_context io;
  Log log;
  link::testing::ScriptedAdapter adapter(io, pty, {});
  auto device = make_device(Kind::depth, "nmea2000", "slcan:" + pty);
  device->listen_only();
  RealTime shell(io, list(std::move(device)), log);
  shell.start();
  run_until(io, [&] { return adapter.got().ends_with("L\r"); });
  shell.stop();
  link::testing::settle(io);
  EXPECT_EQ(adapter.got(), "\rC\rS5\rL\r\rC\r");
}

TEST(RealTimeListening, AListeningLinkKeepsItsDriversFromSending) {
  boost::asio::io_context io;
  Log log;
  const auto bus = link::testing::open_bus(io, "memory-can:hush", Side::device);
  RealTime shell(io, list(make_device(Kind::depth, "nmea2000", "memory-can:hush?listen=1")), log,
                 &log);
  shell.start();
  link::testing::settle(io);
  EXPECT_EQ(shell.device(0).state(), State::waiting);
  shell.stop();
  link::testing::settle(io);
  EXPECT_TRUE(log.frames_sent.empty());
}

TEST(RealTimeListening, ARefusedCommandIsInTheHealthOfTheDevice) {
  const link::testing::Folder folder;
  const std::string pty = "pty:" + folder.file("can");
  boost::asio::io_context io;
  Log log;
  link::testing::ScriptedAdapter adapter(io, pty, {{"S5", "\a"}});
  RealTime shell(io, list(make_device(Kind::depth, "nmea2000", "slcan:" + pty)), log);
  shell.start();
  run_until(io, [&] { return shell.device(0).state() == State::backing_off; });
  EXPECT_NE(std::string(shell.health(0).last_error.view()).find("refused S5 (250000 bit/s)"),
            std::string::npos);
  shell.stop();
  link::testing::settle(io);
}

}  // namespace
}  // namespace drydock::shell
