#include "tests/drivers/link/names.hpp"

#include <gmock/gmock.h>
#include <sys/socket.h>

#include <boost/asio/connect.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/udp.hpp>

#include "drivers/link/net/tcp_options.hpp"
#include "tests/drivers/link/running.hpp"

/// Links whose URI names a host: the name server may be slow, dead or wrong.
namespace drydock::link::testing {
namespace {

using asio::ip::tcp;
using ::testing::HasSubstr;

tcp::endpoint any_port(const char* address) { return {asio::ip::make_address(address), 0}; }

class HostNames : public ::testing::Test {
 protected:
  ~HostNames() override { names::release(); }

  /// A listening device on this address, and the URI under which its driver knows it.
  tcp::acceptor listen(const char* address, const std::string& host) {
    tcp::acceptor acceptor(*io, any_port(address));
    uri = "tcp:" + host + ":" + std::to_string(acceptor.local_endpoint().port());
    return acceptor;
  }

  std::unique_ptr<asio::io_context> io = std::make_unique<asio::io_context>();
  std::string uri;
  Buffer buffer = Buffer(64);
};

class AHangingName : public HostNames, public ::testing::WithParamInterface<const char*> {
 protected:
  AHangingName() {
    static int names_so_far = 0;  // a look-up that has just been released may still be on its way
    const std::string host = "hangs" + std::to_string(++names_so_far) + ".test";
    names::hang(host);
    uri = GetParam() + (":" + host + ":4001");
    slow = open(*io, uri, Side::driver);
    reading = start(*io, slow->read(buffer));
    // Another thread asks; on a busy machine it begins late.
    for (int i = 0; i < 500 && names::hanging() != 1; ++i) settle(*io);
    EXPECT_EQ(names::hanging(), 1) << "nobody asks for the name";
  }
  std::unique_ptr<ByteLink> slow;
  std::shared_ptr<Running<ReceivedBytes>> reading;
};

TEST_P(AHangingName, HoldsUpNoOtherLink) {
  const auto device = open(*io, "memory:beside", Side::device);
  const auto driver = open(*io, "memory:beside", Side::driver);
  for (int i = 0; i < 20; ++i) {
    ASSERT_TRUE(run(*io, device->write(bytes("ensemble"))));
    ASSERT_EQ(run(*io, read_bytes(*driver, 8)).value(), bytes("ensemble"));
  }
  EXPECT_EQ(names::hanging(), 1) << "the other link had to wait for the look-up";
  slow->close();
  settle(*io);
}

TEST_P(AHangingName, LetsTheLinkCloseAndTheProgramEnd) {
  slow->close();
  ASSERT_TRUE(run_until(*io, [&] { return reading->outcome.has_value(); }));
  EXPECT_EQ(reading->outcome->error(), asio::error::operation_aborted);
  slow.reset();
  io->restart();
  io->run();  // returns when nothing is left to do
  io.reset();
  EXPECT_EQ(names::hanging(), 1) << "the end had to wait for the look-up";
}

TEST_P(AHangingName, IsAskedForOnceByAllItsLinks) {
  const auto second = open(*io, uri, Side::driver);
  const auto also_reading = start(*io, second->read(buffer));
  settle(*io);
  EXPECT_EQ(names::hanging(), 1);
  slow->close();
  second->close();
  settle(*io);
}

INSTANTIATE_TEST_SUITE_P(Sockets, AHangingName, ::testing::Values("tcp", "udp"),
                         [](const auto& scheme) { return std::string(scheme.param); });

TEST_F(HostNames, ADeviceWhoseOwnNameHangsSaysSoAndDoesNotWaitForIt) {
  names::hang("own.test");
  for (const char* own : {"tcp:own.test:4001", "udp:own.test:4001"}) {
    const auto device = open_bytes(io->get_executor(), parse_uri(own).value(), Side::device);
    ASSERT_FALSE(device) << own;
    EXPECT_THAT(device.error().message,
                HasSubstr("cannot listen on own.test:4001: the name server does not answer"));
    EXPECT_EQ(names::hanging(), 1);
  }
}

TEST_F(HostNames, ANumberNeedsNoLookUp) {
  const int before = names::lookups();
  auto device = listen("127.0.0.1", "127.0.0.1");
  const auto driver = open(*io, uri, Side::driver);
  ASSERT_TRUE(run(*io, driver->write(bytes("?"))));
  const auto datagrams = open(*io, "udp:127.0.0.1:4001", Side::driver);
  EXPECT_EQ(names::lookups(), before);
}

TEST_F(HostNames, EveryAddressOfANameIsTriedInTurn) {
  auto device = listen("127.0.0.1", "two.test");
  names::answer("two.test", {"127.0.0.2", "127.0.0.1"});  // nobody listens on the first
  const auto driver = open(*io, uri, Side::driver);
  const auto written = run(*io, driver->write(bytes("?")));
  EXPECT_TRUE(written) << written.error().message();
}

/// An address that answers nothing at all, as a host that is switched off: its queue of connections
/// is full.
class Silent {
 public:
  Silent(asio::io_context& io, const tcp::endpoint& where) : acceptor_(io) {
    acceptor_.open(where.protocol());
    acceptor_.bind(where);
    acceptor_.listen(0);
    for (auto& one : crowd_) {
      one.open(where.protocol());
      one.native_non_blocking(true);
      const auto to = acceptor_.local_endpoint();
      ::connect(one.native_handle(), to.data(), static_cast<socklen_t>(to.size()));
    }
  }

 private:
  tcp::acceptor acceptor_;
  std::array<tcp::socket, 4> crowd_{
      tcp::socket{acceptor_.get_executor()}, tcp::socket{acceptor_.get_executor()},
      tcp::socket{acceptor_.get_executor()}, tcp::socket{acceptor_.get_executor()}};
};

TEST_F(HostNames, AnAddressThatIsSilentHasALimitOfTimeAndThenTheNextIsTried) {
  auto device = listen("127.0.0.1", "half.test");
  const Silent off(*io, {asio::ip::make_address("127.0.0.3"), device.local_endpoint().port()});
  names::answer("half.test", {"127.0.0.3", "127.0.0.1"});
  const auto driver = open(*io, uri, Side::driver);
  const auto written = run(*io, driver->write(bytes("?")));
  EXPECT_TRUE(written) << written.error().message();
}

TEST(TcpAddresses, AllOfANameHaveTheirTurnBeforeADeviceOpensItsSilentLinkAnew) {
  EXPECT_EQ(limit_per_address(1), 2s);
  for (std::size_t n = 1; n <= most_addresses; ++n) {
    EXPECT_LE(limit_per_address(n) * n, 8s);
    EXPECT_GE(limit_per_address(n), 250ms);
  }
}

TEST_F(HostNames, TheLastGoodAnswerServesWhileTheNameServerIsDead) {
  auto device = listen("127.0.0.1", "known.test");
  names::answer("known.test", {"127.0.0.1"});
  auto driver = open(*io, uri, Side::driver);
  ASSERT_TRUE(run(*io, driver->write(bytes("?"))));
  driver->close();
  names::hang("known.test");
  driver = open(*io, uri, Side::driver);
  const auto written = run(*io, driver->write(bytes("?")));
  EXPECT_TRUE(written) << written.error().message();
  EXPECT_EQ(names::hanging(), 1);
}

TEST_F(HostNames, ANameThatNobodyKnowsIsSaidInOneLine) {
  names::answer("nobody.test", {"not an address"});
  const auto driver = open(*io, "tcp:nobody.test:4001", Side::driver);
  const auto read = run(*io, driver->read(buffer));
  ASSERT_FALSE(read);
  EXPECT_EQ(
      read.error().message(),
      "the host's name has no address (Name or service not known): correct the name, or write "
      "the address in numbers");
}

}  // namespace
}  // namespace drydock::link::testing
