#include <gmock/gmock.h>

#include <boost/asio/ip/udp.hpp>
#include <fstream>
#include <iterator>

#include "tests/drivers/link/running.hpp"

/// Datagrams to more than one listener: broadcast and multicast, on the loopback interface.
namespace drydock::link::testing {
namespace {

using asio::ip::udp;
using ::testing::HasSubstr;

class Datagrams : public ::testing::Test {
 protected:
  std::string port() {
    udp::socket socket(io, udp::endpoint(udp::v4(), 0));
    return std::to_string(socket.local_endpoint().port());
  }
  std::string refusal(const std::string& uri, Side side) {
    const auto link = open_bytes(io.get_executor(), parse_uri(uri).value(), side);
    return link ? "" : link.error().message;
  }
  void hears(ByteLink& listener, const std::string& text) {
    EXPECT_EQ(run(io, read_bytes(listener, text.size())).value(), bytes(text));
  }

  asio::io_context io;
};

TEST_F(Datagrams, ADeviceThatBroadcastsIsHeardByAllWhoListen) {
  const std::string uri = "udp:127.255.255.255:" + port() + "?listen=1";
  const auto first = open(io, uri, Side::driver), second = open(io, uri, Side::driver);
  ASSERT_TRUE(first && second);
  const auto device = open(io, uri, Side::device);
  const auto written = run(io, device->write(bytes("$GPGGA")));
  ASSERT_TRUE(written) << written.error().message();
  hears(*first, "$GPGGA");
  hears(*second, "$GPGGA");
}

TEST_F(Datagrams, ABroadcastReachesTheListenerOnAllAddressesWhoMayAnswer) {
  const std::string number = port();
  const auto driver = open(io, "udp:0.0.0.0:" + number + "?listen=1", Side::driver);
  const auto device = open(io, "udp:127.255.255.255:" + number + "?listen=1", Side::device);
  ASSERT_TRUE(run(io, device->write(bytes("here"))));
  hears(*driver, "here");
  ASSERT_TRUE(run(io, driver->write(bytes("set"))));
  hears(*device, "set");
}

TEST_F(Datagrams, ADeviceThatSendsToAGroupIsHeardByAllWhoJoinedAndMayBeAnswered) {
  const std::string uri = "udp:239.255.42.99:" + port() + "?listen=1&interface=lo";
  const auto first = open(io, uri, Side::driver), second = open(io, uri, Side::driver);
  ASSERT_TRUE(first && second);
  const auto device = open(io, uri, Side::device);
  const auto written = run(io, device->write(bytes("!AIVDM")));
  ASSERT_TRUE(written) << written.error().message();
  hears(*first, "!AIVDM");
  hears(*second, "!AIVDM");
  ASSERT_TRUE(run(io, first->write(bytes("set"))));
  hears(*device, "set");
  ASSERT_TRUE(run(io, device->write(bytes("again"))));  // to the group, not to who answered
  hears(*second, "again");
}

TEST_F(Datagrams, ADriverFindsADeviceThatListensInAGroup) {
  const std::string uri = "udp:239.255.42.99:" + port() + "?interface=lo";
  const auto device = open(io, uri, Side::device);
  const auto driver = open(io, uri, Side::driver);
  ASSERT_TRUE(run(io, driver->write(bytes("who"))));
  hears(*device, "who");
  ASSERT_TRUE(run(io, device->write(bytes("me"))));
  hears(*driver, "me");
}

// The loopback interface has no route for groups of IPv6, so nothing can be sent there.
TEST_F(Datagrams, AGroupOfIpv6IsJoinedOnItsInterface) {
  const auto memberships = [] {
    std::ifstream file("/proc/net/igmp6");
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const std::string entry = "ff020000000000000000000000004242";
  EXPECT_THAT(memberships(), ::testing::Not(HasSubstr(entry)));
  const auto driver =
      open(io, "udp:[ff02::4242]:" + port() + "?listen=1&interface=lo", Side::driver);
  EXPECT_THAT(memberships(), HasSubstr(entry));
}

TEST_F(Datagrams, AnInterfaceThatIsNotThereIsSaidInOneLine) {
  for (const Side side : {Side::driver, Side::device})
    EXPECT_EQ(
        refusal("udp:239.255.42.99:4001?listen=1&interface=nosuch0", side),
        "cannot use 239.255.42.99:4001: there is no interface nosuch0 (ip link shows those that "
        "are there)");
}

TEST_F(Datagrams, AnAddressThatNothingCanBeSentToIsRefusedAtOnce) {
  EXPECT_EQ(refusal("udp:[ff02::4242]:4001?interface=lo", Side::driver),
            "cannot send to [ff02::4242]:4001: Network is unreachable (no route leads there; name "
            "the network of a group, as in interface=eth0)");
}

TEST_F(Datagrams, AnInterfaceIsOnlyForAGroup) {
  EXPECT_EQ(refusal("udp:127.0.0.1:4001?listen=1&interface=lo", Side::driver),
            "cannot use 127.0.0.1:4001 with interface=lo: only a multicast group (224.0.0.0 to "
            "239.255.255.255, ff00::/8) has one");
}

TEST_F(Datagrams, APortThatOnlyOneMayHaveIsNotTakenFromItsOwner) {
  const std::string uri = "udp:127.0.0.1:" + port() + "?listen=1";
  const auto owner = open(io, uri, Side::driver);
  EXPECT_THAT(refusal(uri, Side::driver), HasSubstr("Address already in use"));
}

/// Hosts of the loopback network that send to one port, and a driver that listens there.
class Strangers : public Datagrams {
 protected:
  void send(const std::string& host, const std::string& text) {
    udp::socket socket(io, udp::endpoint(asio::ip::make_address(host), 0));
    socket.send_to(asio::buffer(text), {asio::ip::make_address("127.0.0.1"), number});
  }
  std::unique_ptr<ByteLink> listener(const std::string& query = "") {
    return open(io, "udp:0.0.0.0:" + std::to_string(number) + "?listen=1" + query, Side::driver);
  }

  std::uint16_t number = static_cast<std::uint16_t>(std::stoi(port()));
};

TEST_F(Strangers, OnlyTheHostThatIsHeardFirstCounts) {
  const auto driver = listener();
  send("127.0.0.1", "$GP");
  send("127.0.0.2", "forged");
  send("127.0.0.1", "GGA");
  hears(*driver, "$GPGGA");
  EXPECT_EQ(driver->note(),
            "1 datagrams of others were dropped, the last of 127.0.0.2: only 127.0.0.1 counts "
            "(heard first; from= names another)");
}

TEST_F(Strangers, OnlyTheHostThatTheUriNamesCounts) {
  const auto driver = listener("&from=127.0.0.2");
  for (int i = 0; i < 3; ++i) send("127.0.0.1", "forged");
  send("127.0.0.2", "$GPGGA");
  hears(*driver, "$GPGGA");
  EXPECT_THAT(std::string(driver->note()),
              ::testing::AllOf(HasSubstr("3 datagrams"), HasSubstr("127.0.0.2 counts (from=)")));
}

TEST_F(Strangers, ASensorMaySendFromAnotherPortAfterItsRestart) {
  const auto driver = listener();
  send("127.0.0.1", "before");
  send("127.0.0.1", "after");
  hears(*driver, "beforeafter");
  EXPECT_EQ(driver->note(), "");
}

TEST_F(Strangers, AnEmptyDatagramIsNoSenderHeard) {
  const auto driver = listener();
  send("127.0.0.2", "");
  send("127.0.0.1", "$GPGGA");
  hears(*driver, "$GPGGA");
}

TEST_F(Strangers, TheLongestDatagramOfIpv4ComesWhole) {
  const auto driver = listener();
  const std::string longest(65'507, 'x');
  send("127.0.0.1", longest);
  hears(*driver, longest);
}

TEST_F(Strangers, AFloodOfStrangersDoesNotHideTheSensor) {
  const auto driver = listener("&from=127.0.0.1");
  for (int i = 0; i < 100; ++i) {
    send("127.0.0.2", "flood");
    if (i % 10 == 9) send("127.0.0.1", std::to_string(i / 10));
    settle(io);
  }
  hears(*driver, "0123456789");
}

TEST_F(Strangers, ADriverLearnsThatNobodyListensAtItsDevice) {
  const auto driver = open(io, "udp:127.0.0.1:" + std::to_string(number), Side::driver);
  const auto read = run(io, read_bytes(*driver, 1));
  EXPECT_TRUE(read.value().empty());  // the network's refusal ends the link, and it is opened again
}

TEST_F(Strangers, ASenderWithoutNumbersIsRefusedInOneLine) {
  EXPECT_EQ(refusal("udp:0.0.0.0:4001?listen=1&from=1.2.3", Side::driver),
            "cannot use 0.0.0.0:4001 with from=1.2.3: it is no IP address in numbers, as "
            "192.168.2.95 or fe80::1");
}

}  // namespace
}  // namespace drydock::link::testing
