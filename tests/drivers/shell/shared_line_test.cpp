// Several devices on one line, as behind a ship's multiplexer, in real time.
#include <gmock/gmock.h>

#include "drivers/shell/real_time.hpp"
#include "tests/drivers/link/scripted_adapter.hpp"

namespace drydock::shell {
namespace shared_line_test {

using device::Kind;
using device::State;
using link::testing::run;
using link::testing::run_until;
using namespace std::chrono_literals;

const std::string log_speed = "$HCVHW,,,,,0.2,N,0,K*5B\r\n", heading = "$HEHDT,10.0,T*1E\r\n";
constexpr const char* uri = "memory:shared-line";

struct Heard final : device::Listener, RawListener {
  void on_measurement(const measurement::Measurement& m) override {
    ++measurements.at(measurement::origin_of(m).device);
  }
  void on_state(const device::Device&, const device::Transition&) override {}
  void on_bytes(std::string_view, Direction direction, wire::Bytes bytes, Stamp) override {
    (direction == Direction::sent ? sent : received)
        .append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  }
  void on_frame(std::string_view, Direction, const wire::CanFrame&, Stamp) override {}

  std::vector<int> measurements = std::vector<int>(2);
  std::string received, sent;
};

std::unique_ptr<device::Device> make_device(Kind kind, std::uint16_t index) {
  device::DeviceOptions options;
  options.name = to_string(kind);
  options.link = uri;
  options.driver.kind = kind;
  options.driver.protocol = "nmea0183";
  options.driver.device = index;
  options.life_cycle.stale_after = 100ms;
  options.life_cycle.reopen_after = 200ms;
  options.life_cycle.first_back_off = 20ms;
  return *device::Device::make(options);
}

std::vector<std::unique_ptr<device::Device>> log_and_compass() {
  std::vector<std::unique_ptr<device::Device>> devices;
  devices.push_back(make_device(Kind::emlog, 0));
  devices.push_back(make_device(Kind::attitude, 1));
  return devices;
}

class SharedLine : public testing::Test {
 protected:
  SharedLine() {
    plugged = *link::open_bytes(io.get_executor(), *link::parse_uri(uri), link::Side::device);
    shell.start();
    EXPECT_TRUE(run_until(io, [&] { return are(State::waiting); }));
  }
  ~SharedLine() override {
    shell.stop();
    io.restart();
    io.run_for(5s);  // returns as soon as every coroutine has ended
    EXPECT_TRUE(io.stopped()) << "a coroutine is still waiting";
  }
  bool are(State state) {
    return shell.device(0).state() == state && shell.device(1).state() == state;
  }
  void say(const std::string& text) {
    ASSERT_TRUE(run(io, plugged->write(std::span(reinterpret_cast<const std::uint8_t*>(text.data()),
                                                 text.size()))));
  }

  boost::asio::io_context io;
  std::unique_ptr<link::ByteLink> plugged;
  Heard heard;
  RealTime shell{io, log_and_compass(), heard, &heard};
};

TEST_F(SharedLine, IsOpenedOnceAndItsBytesReachEveryDriverAndOnceTheTap) {
  say(log_speed + heading);
  ASSERT_TRUE(run_until(io, [&] { return are(State::streaming); }));
  EXPECT_THAT(heard.measurements, testing::Each(1));
  EXPECT_EQ(heard.received, log_speed + heading);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(shell.health(i).stream.bytes_skipped, 0u);
    EXPECT_EQ(shell.health(i).stream.bad_checksums, 0u);
  }
}

TEST_F(SharedLine, StaysOpenWhileOneOfItsDevicesIsHeard) {
  for (int i = 0; i < 8; ++i) {  // longer than reopen_after
    say(log_speed);
    io.restart();
    io.run_for(50ms);
  }
  EXPECT_EQ(shell.device(0).state(), State::streaming);
  EXPECT_EQ(shell.device(1).state(), State::waiting);
  EXPECT_EQ(shell.health(0).reopened + shell.health(1).reopened, 0u);
  say(heading);
  EXPECT_TRUE(run_until(io, [&] { return shell.device(1).state() == State::streaming; }))
      << "a device that comes late is heard";
}

TEST_F(SharedLine, IsOpenedAgainWhenAllOfItsDevicesAreSilent) {
  say(log_speed + heading);
  ASSERT_TRUE(run_until(io, [&] { return are(State::streaming); }));
  ASSERT_TRUE(run_until(io, [&] {
    return shell.health(0).reopened == 1 && shell.health(1).reopened == 1 && are(State::waiting);
  }));
  say(log_speed + heading);
  EXPECT_TRUE(run_until(io, [&] { return are(State::streaming); }));
}

}  // namespace shared_line_test
}  // namespace drydock::shell
