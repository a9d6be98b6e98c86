#include <dirent.h>
#include <gmock/gmock.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>

#include "tests/drivers/link/running.hpp"

/// The device's end of a TCP link: whatever one client does, the device goes on.
namespace drydock::link::testing {
namespace {

using asio::ip::tcp;

constexpr std::size_t chunk = 64 * 1024;

class TcpDevice : public ::testing::Test {
 protected:
  ~TcpDevice() override {
    device->close();
    settle(io);
  }

  std::uint16_t free_port() {
    return tcp::acceptor(io, {asio::ip::make_address("127.0.0.1"), 0}).local_endpoint().port();
  }
  void make(const std::string& keys = "") {
    device = open(io, "tcp:127.0.0.1:" + std::to_string(port) + keys, Side::device);
  }
  tcp::socket join() {
    tcp::socket client(io);
    client.connect({asio::ip::make_address("127.0.0.1"), port});
    settle(io);
    return client;
  }
  void say(const std::string& text) { ASSERT_TRUE(run(io, device->write(bytes(text)))); }
  /// What the client reads now, up to `most` bytes; with its end, "END".
  std::string heard(tcp::socket& client, std::size_t most = 64) {
    settle(io);
    client.non_blocking(true);
    std::string text(most, '\0');
    boost::system::error_code error;
    const std::size_t size = client.read_some(asio::buffer(text), error);
    text.resize(size);
    return error == asio::error::eof || error == asio::error::connection_reset ? "END" : text;
  }

  asio::io_context io;
  std::uint16_t port = free_port();
  std::unique_ptr<ByteLink> device;
  Buffer buffer = Buffer(64);
};

TEST_F(TcpDevice, AClientThatNeverReadsIsLeftAndEachByteIsDeliveredOrCounted) {
  make();
  tcp::socket client = join();
  const Buffer part(chunk, 'x');
  std::uint64_t written = 0;
  for (; device->dropped() == 0 && written < 300 * chunk; written += chunk)
    ASSERT_TRUE(run(io, device->write(part))) << "held up by a client";
  Buffer all(written);
  boost::system::error_code end;
  const std::size_t delivered = asio::read(client, asio::buffer(all), end);
  EXPECT_TRUE(end) << "the client is still connected";
  EXPECT_GT(device->dropped(), 0U);
  EXPECT_EQ(delivered + device->dropped(), written);
}

TEST_F(TcpDevice, TheNextClientFindsItServedWhileAnotherOneNeverReads) {
  make();
  const tcp::socket stuck = join();
  const Buffer much(300 * chunk, 'x');
  auto stuffing = start(io, device->write(much));
  settle(io);
  tcp::socket second = join();
  ASSERT_TRUE(run_until(
      io, [&] { return stuffing->outcome.has_value(); }, 500ms));
  say("here");
  const std::string all = heard(second, 65536);
  EXPECT_THAT(all, ::testing::EndsWith("here"));
}

/// Every 50 ms it reads 3 KB: never nothing for 1 s, and never as much as the device sends.
TEST_F(TcpDevice, AClientThatReadsALittleNowAndThenIsLeftToo) {
  make();
  tcp::socket slow(io);
  slow.open(tcp::v4());
  slow.set_option(asio::socket_base::receive_buffer_size(4096));
  slow.connect({asio::ip::address_v4::loopback(), port});
  settle(io);
  slow.non_blocking(true);
  const Buffer much(300 * chunk, 'x');
  auto stuffing = start(io, device->write(much));
  Buffer little(3000);
  auto next = std::chrono::steady_clock::now();
  const auto reads_a_little = [&] {
    if (std::chrono::steady_clock::now() >= next) {
      boost::system::error_code nothing;
      slow.read_some(asio::buffer(little), nothing);
      next += 50ms;
    }
    return stuffing->outcome.has_value();
  };
  EXPECT_TRUE(run_until(io, reads_a_little, 5s)) << "held up by a client";
  EXPECT_GT(device->dropped(), 0U);
}

TEST_F(TcpDevice, TheNewestClientIsServedWhereThereIsRoomForOne) {
  make();
  tcp::socket first = join();
  say("one");
  EXPECT_EQ(heard(first), "one");
  tcp::socket second = join();
  EXPECT_EQ(heard(first), "END");
  say("two");
  EXPECT_EQ(heard(second), "two");
  asio::write(second, asio::buffer("?", 1));
  EXPECT_EQ(run(io, read_bytes(*device, 1)).value(), bytes("?"));
}

TEST_F(TcpDevice, SeveralClientsHearTheSameAndAreAllHeard) {
  make("?clients=2");
  tcp::socket first = join(), second = join();
  say("both");
  EXPECT_EQ(heard(first), "both");
  EXPECT_EQ(heard(second), "both");
  asio::write(first, asio::buffer("a", 1));
  EXPECT_EQ(run(io, read_bytes(*device, 1)).value(), bytes("a"));
  asio::write(second, asio::buffer("b", 1));
  EXPECT_EQ(run(io, read_bytes(*device, 1)).value(), bytes("b"));
  tcp::socket third = join();
  EXPECT_EQ(heard(first), "END") << "the oldest makes room";
  say("last");
  EXPECT_EQ(heard(second), "last");
  EXPECT_EQ(heard(third), "last");
}

TEST_F(TcpDevice, AnAnswerGoesOnlyToTheClientThatSpoke) {
  make("?clients=2");
  tcp::socket first = join(), second = join();
  asio::write(second, asio::buffer("?", 1));
  EXPECT_EQ(run(io, read_bytes(*device, 1)).value(), bytes("?"));
  const auto asker = device->speaker();
  asio::write(first, asio::buffer("!", 1));
  EXPECT_EQ(run(io, read_bytes(*device, 1)).value(), bytes("!"));
  EXPECT_NE(device->speaker(), asker);
  ASSERT_TRUE(run(io, device->write_to(asker, bytes("answer"))));
  say("to all");
  EXPECT_EQ(heard(second), "answerto all");
  EXPECT_EQ(heard(first), "to all");
}

TEST_F(TcpDevice, AnAnswerToAClientThatHasLeftIsCountedAsLost) {
  make("?clients=2");
  tcp::socket client = join();
  asio::write(client, asio::buffer("?", 1));
  EXPECT_EQ(run(io, read_bytes(*device, 1)).value(), bytes("?"));
  const auto asker = device->speaker();
  client.close();
  settle(io);
  const tcp::socket other = join();
  ASSERT_TRUE(run(io, device->write_to(asker, bytes("answer"))));
  EXPECT_EQ(device->dropped(), 6U);
}

TEST_F(TcpDevice, BesideAStuckClientTheOtherOneHearsEverything) {
  make("?clients=2");
  const tcp::socket stuck = join();
  tcp::socket reader = join();
  const Buffer much(200 * chunk, 'x');
  const auto writing = start(io, device->write(much));
  std::size_t heard_so_far = 0;
  Buffer all(much.size());
  asio::async_read(reader, asio::buffer(all),
                   [&](boost::system::error_code, std::size_t size) { heard_so_far = size; });
  ASSERT_TRUE(run_until(io, [&] { return heard_so_far > 0; }));
  EXPECT_EQ(heard_so_far, much.size());
  ASSERT_TRUE(run_until(io, [&] { return writing->outcome.has_value(); }));
  EXPECT_GT(device->dropped(), 0U);
}

TEST_F(TcpDevice, WhatItHasTakenStillArrivesAfterItIsClosed) {
  make();
  tcp::socket client = join();
  const Buffer much(60 * chunk, 'x');
  const auto writing = start(io, device->write(much));
  std::size_t heard_so_far = 0;
  Buffer all(much.size());
  asio::async_read(client, asio::buffer(all),
                   [&](boost::system::error_code, std::size_t size) { heard_so_far = size; });
  ASSERT_TRUE(run_until(io, [&] { return writing->outcome.has_value(); }));
  device->close();
  ASSERT_TRUE(run_until(io, [&] { return heard_so_far > 0; }));
  EXPECT_EQ(heard_so_far, all.size());
  EXPECT_EQ(device->dropped(), 0U);
}

/// The option of the device's socket to a client, found among the descriptors of this process.
int option_at_device(std::uint16_t port, int level, int name) {
  for (int fd = 3; fd < 256; ++fd) {
    sockaddr_in own{}, peer{};
    socklen_t size = sizeof own, peer_size = sizeof peer;
    if (::getsockname(fd, reinterpret_cast<sockaddr*>(&own), &size) != 0 ||
        ::getpeername(fd, reinterpret_cast<sockaddr*>(&peer), &peer_size) != 0 ||
        own.sin_port != htons(port))
      continue;
    int value = -1;
    socklen_t length = sizeof value;
    ::getsockopt(fd, level, name, &value, &length);
    return value;
  }
  return -1;
}

// docs/use/links.md: 2 s + 3 questions a second apart, and 5 s for bytes without an answer.
TEST_F(TcpDevice, AHostThatVanishesIsNoticedAsByTheDriver) {
  make();
  const tcp::socket client = join();
  EXPECT_EQ(option_at_device(port, IPPROTO_TCP, TCP_USER_TIMEOUT), 5000);
  EXPECT_EQ(option_at_device(port, SOL_SOCKET, SO_KEEPALIVE), 1);
  EXPECT_EQ(option_at_device(port, IPPROTO_TCP, TCP_KEEPIDLE), 2);
  EXPECT_EQ(option_at_device(port, IPPROTO_TCP, TCP_KEEPINTVL), 1);
  EXPECT_EQ(option_at_device(port, IPPROTO_TCP, TCP_KEEPCNT), 3);
}

}  // namespace
}  // namespace drydock::link::testing
