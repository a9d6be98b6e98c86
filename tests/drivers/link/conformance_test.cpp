#include <gmock/gmock.h>

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/udp.hpp>
#include <numeric>

#include "tests/drivers/link/running.hpp"

/// The rules for every byte link, whatever its transport.
namespace drydock::link::testing {
namespace {

template <class Protocol>
std::string free_address() {
  asio::io_context io;
  const typename Protocol::endpoint any(asio::ip::make_address("127.0.0.1"), 0);
  typename Protocol::socket socket(io, any);
  return "127.0.0.1:" + std::to_string(socket.local_endpoint().port());
}

struct Kind {
  const char* name;
  std::string (*uri)(const Folder&);
};

const Kind kinds[]{
    {"Pty", [](const Folder& folder) { return "pty:" + folder.file("line") + "?baud=115200"; }},
    {"Memory", [](const Folder&) { return std::string("memory:line"); }},
    {"Tcp", [](const Folder&) { return "tcp:" + free_address<asio::ip::tcp>(); }},
    {"Udp", [](const Folder&) { return "udp:" + free_address<asio::ip::udp>(); }},
};

std::string kind_name(const ::testing::TestParamInfo<Kind>& kind) { return kind.param.name; }

class EveryByteLink : public ::testing::TestWithParam<Kind> {
 protected:
  EveryByteLink() { device = open(io, uri, Side::device); }

  void join() {
    driver = open(io, uri, Side::driver);
    meet();
  }

  /// Sends one byte from the driver. After it a socket knows its peer.
  void meet() {
    ASSERT_TRUE(run(io, driver->write(bytes("?"))));
    ASSERT_EQ(run(io, read_bytes(*device, 1)).value(), bytes("?"));
  }

  Folder folder;
  std::string uri = GetParam().uri(folder);
  asio::io_context io;
  std::unique_ptr<ByteLink> device, driver;
  Buffer buffer = Buffer(4096);
};

TEST_P(EveryByteLink, CarriesAllByteValuesUnchangedBothWays) {
  join();
  Buffer all(256);
  std::iota(all.begin(), all.end(), std::uint8_t{0});

  ASSERT_TRUE(run(io, driver->write(all)));
  EXPECT_EQ(run(io, read_bytes(*device, all.size())).value(), all);
  ASSERT_TRUE(run(io, device->write(all)));
  EXPECT_EQ(run(io, read_bytes(*driver, all.size())).value(), all);

  const auto echo = start(io, driver->read(buffer));
  settle(io);
  EXPECT_FALSE(echo->outcome) << "more came back than was sent";
  driver->close();
  settle(io);
}

TEST_P(EveryByteLink, StampsWhatItReads) {
  join();
  const Stamp before = now();
  ASSERT_TRUE(run(io, device->write(bytes("a"))));
  const auto received = run(io, driver->read(buffer));
  ASSERT_TRUE(received);
  EXPECT_GE(received->at, before);
  EXPECT_LE(received->at, now());
}

TEST_P(EveryByteLink, ClosingEndsAPendingRead) {
  join();
  for (ByteLink* link : {driver.get(), device.get()}) {
    const auto pending = start(io, link->read(buffer));
    settle(io);
    ASSERT_FALSE(pending->outcome);
    link->close();
    ASSERT_TRUE(run_until(io, [&] { return pending->outcome.has_value(); }));
    EXPECT_EQ(pending->outcome->error(), asio::error::operation_aborted);
  }
}

TEST_P(EveryByteLink, TellsTheDriverThatTheDeviceIsGone) {
  join();
  device->close();
  device.reset();
  settle(io);
  (void)run(io, driver->write(bytes("anybody?")));  // a socket learns its peer from a datagram
  const auto first = run(io, driver->read(buffer));
  ASSERT_FALSE(first) << "read " << first->size << " bytes of nobody";
  EXPECT_NE(first.error(), asio::error::timed_out);
}

TEST_P(EveryByteLink, WorksAgainWhenTheDeviceIsBackAndTheDriverReopens) {
  join();
  driver->close();
  device->close();
  driver.reset();
  device.reset();
  settle(io);
  device = open(io, uri, Side::device);
  ASSERT_TRUE(device);
  join();
  ASSERT_TRUE(run(io, device->write(bytes("back"))));
  EXPECT_EQ(run(io, read_bytes(*driver, 4)).value(), bytes("back"));
}

TEST_P(EveryByteLink, OutlivesItsDriversOnTheDeviceSide) {
  join();
  const auto pending = start(io, device->read(buffer));
  driver->close();
  driver.reset();
  settle(io);
  EXPECT_FALSE(pending->outcome) << "the device must not notice";

  driver = open(io, uri, Side::driver);
  ASSERT_TRUE(run(io, driver->write(bytes("!"))));
  ASSERT_TRUE(run_until(io, [&] { return pending->outcome.has_value(); }));
  EXPECT_EQ(pending->outcome->value().size, 1U);
  EXPECT_EQ(buffer[0], '!');
}

TEST_P(EveryByteLink, LosesWhatIsSentWhileNobodyListens) {
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(run(io, device->write(Buffer(2048, 'x'))));
  join();
  ASSERT_TRUE(run(io, device->write(bytes("fresh"))));
  EXPECT_EQ(run(io, read_bytes(*driver, 5)).value(), bytes("fresh"));
}

INSTANTIATE_TEST_SUITE_P(Links, EveryByteLink, ::testing::ValuesIn(kinds), kind_name);

class EveryStream : public EveryByteLink {};

TEST_P(EveryStream, CarriesMoreThanItCanHold) {
  join();
  Buffer much(300'000);
  for (std::size_t i = 0; i < much.size(); ++i) much[i] = static_cast<std::uint8_t>(i * 31 >> 3);
  const auto writing = start(io, device->write(much));
  EXPECT_EQ(run(io, read_bytes(*driver, much.size())).value(), much);
  EXPECT_TRUE(writing->outcome && *writing->outcome);
}

INSTANTIATE_TEST_SUITE_P(Links, EveryStream, ::testing::Values(kinds[0], kinds[1], kinds[2]),
                         kind_name);

}  // namespace
}  // namespace drydock::link::testing
