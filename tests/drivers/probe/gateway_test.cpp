#include <fmt/format.h>
#include <gmock/gmock.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <thread>

#include "drivers/probe/probe_report.hpp"

/// A live line that is read from files alone.
namespace drydock::probe {
namespace gateway_test {

using boost::asio::ip::tcp;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

/// Says the text to one client, then hangs up.
ProbeReport probe_of_server(const std::string& text) {
  boost::asio::io_context io;
  tcp::acceptor server(io, {boost::asio::ip::address_v4::loopback(), 0});
  std::thread serving([&] {
    tcp::socket client = server.accept();
    boost::system::error_code gone;
    boost::asio::write(client, boost::asio::buffer(text), gone);
  });
  auto report = find_sensors(fmt::format("tcp:127.0.0.1:{}", server.local_endpoint().port()), 5);
  serving.join();
  return report;
}

/// Lines as the manual of a Yacht Devices gateway shows them (format RAW).
TEST(Gateway, FramesAsTextAreNamedAndNoWireIsBlamed) {
  std::string lines;
  for (int i = 0; i < 20; ++i)
    lines += fmt::format("17:33:21.{:03} R 09F8017F 50 C3 B8 13 47 D8 2B C6\r\n", 10 * i);
  const auto report = probe_of_server(lines);
  EXPECT_THAT(report.notes, Contains(HasSubstr("sends CAN frames as text (ydwg)")));
  EXPECT_THAT(report.notes, Not(Contains(HasSubstr("RS-422"))));
}

}  // namespace gateway_test
}  // namespace drydock::probe
