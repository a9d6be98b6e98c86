#include "tests/rig_config/problems.hpp"

#include <gtest/gtest.h>

/// Two devices on one link: an error on a line, normal on other links.
namespace drydock::rig_config::test {
namespace shared_lines_test {

using testing::ElementsAre;
using testing::IsEmpty;

std::string log_on(const std::string& link, const std::string& name = "log") {
  return "[[device]]\nname = \"" + name +
         "\"\nkind = \"emlog\"\nprotocol = \"nmea0183\"\nlink = \"" + link + "\"\n";
}

TEST(RigProblems, ALineHasOneDevice) {
  EXPECT_THAT(problems_of(log_on("pty:dvl?baud=4800")),  // the first link has no baud rate
              ElementsAre("r.toml:12:8: /device/1/link: pty:dvl is already the link of 'dvl'; each "
                          "device needs a line of its own"));
  for (const std::string link : {"serial:/dev/ttyUSB0?baud=4800", "udp:0.0.0.0:5000", "memory:a"})
    EXPECT_EQ(problems_of(log_on(link) + log_on(link, "other")).size(), 1u) << link;
}

TEST(RigProblems, AServerAndAFileMayHaveManyDevicesAndABusHas) {
  for (const std::string link : {"tcp:192.168.2.3:10110", "file:dive.nmea?speed=1"})
    EXPECT_THAT(problems_of(log_on(link) + log_on(link, "other")), IsEmpty()) << link;
  EXPECT_THAT(problems_of(std::string(imu_table) +
                          "[[device]]\nname = \"depth\"\nkind = \"depth\"\n"
                          "protocol = \"nmea2000\"\nlink = \"can:auto?listen=1\"\n"),
              IsEmpty());
}

}  // namespace shared_lines_test
}  // namespace drydock::rig_config::test
