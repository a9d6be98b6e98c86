#include <gmock/gmock.h>

#include <boost/asio/post.hpp>
#include <thread>

#include "drivers/monitor/monitor.hpp"
#include "tests/drivers/link/scripted_adapter.hpp"

namespace drydock::monitor {
namespace messages_test {

using link::testing::Folder;
using link::testing::ScriptedAdapter;
using ::testing::HasSubstr;

/// The adapter lacks 250 kbit/s, at which NMEA 2000 runs elsewhere; the depth is PGN 128267.
TEST(MonitorOfMessages, FindsTheBitRateOfAnSlcanBusThatNobodyStatesByListening) {
  const Folder folder;
  const std::string pty = "pty:" + folder.file("can");
  boost::asio::io_context io;
  ScriptedAdapter adapter(io, pty, {{"S5", "\a"}, {"S6 L", "\rT0DF50B23800E803000000FFFF\r"}});
  std::jthread serving([&] { io.run(); });
  MonitorOptions options;
  options.link = "slcan:" + pty;
  options.protocol = "nmea2000";
  options.duration_s = 0.5;
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(monitor_messages(options), 0);
  EXPECT_THAT(::testing::internal::GetCapturedStdout(), HasSubstr("\"depth_m\":10"));
  EXPECT_THAT(::testing::internal::GetCapturedStderr(),
              HasSubstr("500000 bit/s, found by listening"));
  boost::asio::post(io, [&] { adapter.end(); });
}

}  // namespace messages_test
}  // namespace drydock::monitor
