#include <fmt/format.h>
#include <gmock/gmock.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <thread>

#include "drivers/probe/probe_report.hpp"

/// A live line whose text has the frames of a bus.
namespace drydock::probe {
namespace gateway_test {

using boost::asio::ip::tcp;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// Says the text to one client, then hangs up. `scheme` stands before tcp.
ProbeReport probe_of_server(const std::string& text, const std::string& scheme = "") {
  boost::asio::io_context io;
  tcp::acceptor server(io, {boost::asio::ip::address_v4::loopback(), 0});
  std::thread serving([&] {
    tcp::socket client = server.accept();
    boost::system::error_code gone;
    boost::asio::write(client, boost::asio::buffer(text), gone);
  });
  const auto port = server.local_endpoint().port();
  auto report = find_sensors(fmt::format("{}tcp:127.0.0.1:{}", scheme, port), 5);
  serving.join();
  return report;
}

/// Lines as the manual of a Yacht Devices gateway shows them (format RAW).
std::string position_lines() {
  std::string lines;
  for (int i = 0; i < 20; ++i)
    lines += fmt::format("17:33:21.{:03} R 09F8017F 50 C3 B8 13 47 D8 2B C6\r\n", 10 * i);
  return lines;
}

TEST(Gateway, FramesAsTextAreNamedWithTheirLinkAndNoWireIsBlamed) {
  const auto report = probe_of_server(position_lines());
  EXPECT_THAT(report.notes,
              Contains(testing::ContainsRegex("frames as text \\(ydwg\\): probe "
                                              "'gateway:tcp:127.0.0.1:[0-9]+\\?format=ydwg'")));
  EXPECT_THAT(report.notes, Not(Contains(HasSubstr("RS-422"))));
}

/// PGN 129025, position at rapid update, from address 7Fh.
TEST(Gateway, TheSensorsOfItsBusAreFound) {
  const auto report = probe_of_server(position_lines(), "gateway:");
  ASSERT_EQ(report.devices.size(), 1U);
  EXPECT_EQ(report.devices[0].kind, wire::Kind::gnss);
  EXPECT_EQ(report.devices[0].address, 0x7FU);
  EXPECT_THAT(report.devices[0].link, testing::StartsWith("gateway:tcp:127.0.0.1:"));
}

}  // namespace gateway_test
}  // namespace drydock::probe
