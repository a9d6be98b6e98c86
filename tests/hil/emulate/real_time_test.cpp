#include "hil/emulate/real_time/real_time.hpp"

#include <gtest/gtest.h>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <ctime>

#include "drivers/link/link.hpp"
#include "drivers/wire/canopen/canopen.hpp"
#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "hil/motion/kinematic_trajectory.hpp"
#include "tests/hil/emulate/bench.hpp"

namespace drydock::emulate {
namespace {

namespace asio = boost::asio;
using rig_config::DeviceKind;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double most_busy = 1;
#else
constexpr double most_busy = 0.1;
#endif

// These tests need the host's clock and take the time that they state. They do not test how late
// the host wakes, only what must hold for any lateness.
class RealTime : public testing::Test {
 protected:
  rig_config::DeviceConfig on(const std::string& link, rig_config::DeviceConfig config) {
    config.link = link;
    return config;
  }

  // Opens the driver's side and collects all input until the emulator stops.
  void listen_bytes(const std::string& uri) {
    bytes_link_ =
        link::open_bytes(io_.get_executor(), link::parse_uri(uri).value(), link::Side::driver)
            .value();
    asio::co_spawn(
        io_,
        [this]() -> asio::awaitable<void> {
          std::array<std::uint8_t, 256> buffer;
          for (;;) {
            const auto got = co_await bytes_link_->read(buffer);
            if (!got) co_return;
            heard_.insert(heard_.end(), buffer.begin(),
                          buffer.begin() + static_cast<std::ptrdiff_t>(got->size));
          }
        },
        asio::detached);
  }

  void listen_frames(const std::string& uri, const wire::CanFrame& say_first) {
    frame_link_ =
        link::open_frames(io_.get_executor(), link::parse_uri(uri).value(), link::Side::driver)
            .value();
    asio::co_spawn(
        io_,
        [this, say_first]() -> asio::awaitable<void> {
          const auto said = co_await frame_link_->write(say_first);
          if (!said) co_return;
          for (;;) {
            const auto got = co_await frame_link_->read();
            if (!got) co_return;
            if (!got->own) frames_.push_back(got->frame);
          }
        },
        asio::detached);
  }

  // Runs for this time, then stops everything. The loop must end by itself.
  void run(RealTimeEmulator& emulator, std::chrono::milliseconds duration) {
    asio::steady_timer timer(io_, duration);
    timer.async_wait([&](const boost::system::error_code&) {
      emulator.stop();
      if (bytes_link_) bytes_link_->close();
      if (frame_link_) frame_link_->close();
    });
    io_.run();
  }

  asio::io_context io_;
  std::unique_ptr<link::ByteLink> bytes_link_;
  std::unique_ptr<link::FrameLink> frame_link_;
  std::vector<std::uint8_t> heard_;
  std::vector<wire::CanFrame> frames_;
  motion::KinematicTrajectory trajectory_{rig_config::MissionConfig{}, link::now()};
  SoundDevices devices_{trajectory_, 1};
};

TEST_F(RealTime, ALineOf4800BaudCarriesNoMoreThanItsRate) {
  const Stamp begin = trajectory_.start();  // the device boots then, before the emulator starts
  RealTimeEmulator emulator(io_, devices_);
  int hooks = 0;
  emulator.set_on_written(
      [&](std::string_view name, const Passage&, Stamp) { hooks += name == "nmea0183 device"; });
  const std::string uri = "memory:paced-log?baud=4800";
  ASSERT_TRUE(emulator.start({on(uri, device(DeviceKind::emlog, "nmea0183", 20))}));
  listen_bytes(uri);
  run(emulator, std::chrono::milliseconds{1500});
  const double elapsed = measurement::seconds(link::now() - begin);
  EXPECT_LE(heard_.size(), elapsed * 480 + 1);
  EXPECT_GT(heard_.size(), 300);
  EXPECT_GT(emulator.counters().lost, 0u);  // the line cannot carry twenty samples a second
  EXPECT_EQ(static_cast<std::uint64_t>(hooks), emulator.counters().messages);
}

TEST_F(RealTime, OnAPtyWholeSoundSentencesArrive) {
  RealTimeEmulator emulator(io_, devices_);
  const std::string uri = "pty:emulate-test-log?baud=4800";
  ASSERT_TRUE(emulator.start({on(uri, device(DeviceKind::emlog, "nmea0183", 2))}));
  listen_bytes(uri);
  run(emulator, std::chrono::milliseconds{1200});
  int sentences = 0;
  wire::Framer<wire::Nmea0183::max_frame> framer;
  framer.feed(heard_, wire::Nmea0183::scan, [&](wire::Bytes, std::size_t) { ++sentences; });
  EXPECT_EQ(framer.counters().bad_checksums, 0u);
  EXPECT_GE(sentences, 3);
  EXPECT_EQ(emulator.counters().write_errors, 0u);
}

TEST_F(RealTime, EveryClientHearsTheReportsAndOnlyTheAskerItsAnswer) {
  using asio::ip::tcp;
  const auto port =
      tcp::acceptor(io_, {asio::ip::address_v4::loopback(), 0}).local_endpoint().port();
  RealTimeEmulator emulator(io_, devices_);
  const std::string uri = "tcp:127.0.0.1:" + std::to_string(port) + "?emulated=1&clients=2";
  ASSERT_TRUE(emulator.start({on(uri, device(DeviceKind::dvl, "water-linked-json", 10))}));
  tcp::socket asker(io_), other(io_);
  for (tcp::socket* client : {&asker, &other})
    client->connect({asio::ip::address_v4::loopback(), port});
  asio::write(asker, asio::buffer(std::string(R"({"command":"get_config"})")));
  run(emulator, std::chrono::milliseconds{600});
  const auto all_of = [](tcp::socket& client) {
    std::string text;
    boost::system::error_code end;
    asio::read(client, asio::dynamic_buffer(text), end);
    return text;
  };
  const std::string to_asker = all_of(asker), to_other = all_of(other);
  for (const std::string* heard : {&to_asker, &to_other})
    EXPECT_NE(heard->find("\"type\":\"velocity\""), std::string::npos);
  EXPECT_NE(to_asker.find("\"type\":\"response\""), std::string::npos);
  EXPECT_EQ(to_other.find("\"type\":\"response\""), std::string::npos);
}

TEST_F(RealTime, DevicesThatNameOneBusShareItAndHearTheDriver) {
  RealTimeEmulator emulator(io_, devices_);
  const std::string uri = "memory-can:emulate-test";
  ASSERT_TRUE(emulator.start({on(uri, device(DeviceKind::imu, "cia404-imu", 100)),
                              on(uri, device(DeviceKind::depth, "nmea2000", 5))}));
  listen_frames(uri,
                wire::canopen::encode(wire::canopen::Nmt{wire::canopen::NmtCommand::start, 0}));
  run(emulator, std::chrono::milliseconds{1000});
  int imu = 0, depth = 0;
  for (const auto& frame : frames_) {
    imu += frame.id == 0x181;
    depth += (frame.id >> 8 & 0x3FFFF) == 130314;
  }
  EXPECT_GE(imu, 50);
  EXPECT_GE(depth, 2);
}

/// One frame is a fast packet that is too short for a group function.
TEST_F(RealTime, WhatANodeOfABusWasToldIsSaid) {
  RealTimeEmulator emulator(io_, devices_);
  std::vector<std::string> told;
  emulator.set_on_told([&](std::string_view name, std::string_view what) {
    told.push_back(std::string(name) + ": " + std::string(what));
  });
  const std::string uri = "memory-can:emulate-told";
  ASSERT_TRUE(emulator.start({on(uri, device(DeviceKind::emlog, "nmea2000", 5))}));
  wire::CanFrame asked;
  asked.id = 0x0DEDFF64;  // PGN 126208 from 64h to all
  asked.extended = true;
  asked.size = 8;
  asked.data = {0, 3, 0, 0x11, 0xF0, 0xFF, 0xFF, 0xFF};
  asio::steady_timer later(io_, std::chrono::milliseconds{500});
  later.async_wait([&](const boost::system::error_code&) { listen_frames(uri, asked); });
  run(emulator, std::chrono::milliseconds{800});
  EXPECT_EQ(told, std::vector<std::string>{
                      "nmea2000 device: a group function (126208) that is too short, not obeyed"});
}

TEST_F(RealTime, SixDevicesNeedLittleOfOneProcessor) {
  RealTimeEmulator emulator(io_, devices_);
  const std::string bus = "memory-can:six-devices";
  ASSERT_TRUE(
      emulator.start({on("memory:six-dvl?baud=115200", device(DeviceKind::dvl, "pd0", 5)),
                      on("memory:six-log?baud=4800", device(DeviceKind::emlog, "nmea0183", 2)),
                      on("memory:six-gnss?baud=38400", device(DeviceKind::gnss, "ubx", 5)),
                      on(bus, device(DeviceKind::imu, "aceinna", 100)),
                      on(bus, device(DeviceKind::depth, "nmea2000", 5)),
                      on(bus, device(DeviceKind::actuator, "nmea2000", 10))}));
  const std::clock_t before = std::clock();
  run(emulator, std::chrono::milliseconds{2000});
  const double busy = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC / 2;
  RecordProperty("processor_share", std::to_string(busy));
  EXPECT_LT(busy, most_busy);
  EXPECT_GT(emulator.counters().messages, 400u);
  EXPECT_EQ(emulator.counters().lost, 0u);
}

TEST_F(RealTime, ADeviceThatCannotBeMadeOrOpenedIsNamed) {
  RealTimeEmulator emulator(io_, devices_);
  const auto unknown = emulator.start({on("memory:x", device(DeviceKind::dvl, "ubx"))});
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().message.find(
                "device \"ubx device\": no emulated dvl speaks \"ubx\"; allowed: pd0, pd4, "
                "pd5, pd6, water-linked, water-linked-json, nortek"),
            0u);
  const auto no_link = emulator.start({on("carrier-pigeon:x", device(DeviceKind::dvl, "pd0"))});
  ASSERT_FALSE(no_link);
  EXPECT_EQ(no_link.error().message.find("device \"pd0 device\": "), 0u);
}

}  // namespace
}  // namespace drydock::emulate
