#include "tests/rig_config/problems.hpp"

#include <gtest/gtest.h>

/// Two devices on one link share it, if they write it alike.
namespace drydock::rig_config::test {
namespace shared_lines_test {

using testing::ElementsAre;
using testing::IsEmpty;

std::string log_on(const std::string& link, const std::string& name = "log") {
  return "[[device]]\nname = \"" + name +
         "\"\nkind = \"emlog\"\nprotocol = \"nmea0183\"\nlink = \"" + link + "\"\n";
}

TEST(RigProblems, DevicesOfOneLineWriteItsLinkAlike) {
  EXPECT_THAT(problems_of(log_on("pty:dvl?baud=4800")),  // the first link has no baud rate
              ElementsAre("r.toml:12:8: /device/1/link: pty:dvl is the link of 'dvl' too, which "
                          "writes pty:dvl; devices that share a line write its link alike"));
  EXPECT_EQ(problems_of(log_on("serial:/dev/ttyUSB0?baud=4800") +
                        log_on("serial:/dev/ttyUSB0?baud=9600", "other"))
                .size(),
            1u);
}

TEST(RigProblems, EveryLinkMayHaveManyDevices) {
  for (const std::string link : {"serial:/dev/ttyUSB0?baud=4800", "udp:0.0.0.0:5000", "memory:a",
                                 "pty:boat", "tcp:192.168.2.3:10110", "file:dive.nmea?speed=1"})
    EXPECT_THAT(problems_of(log_on(link) + log_on(link, "other")), IsEmpty()) << link;
  EXPECT_THAT(problems_of(std::string(imu_table) +
                          "[[device]]\nname = \"depth\"\nkind = \"depth\"\n"
                          "protocol = \"nmea2000\"\nlink = \"can:auto?listen=1\"\n"),
              IsEmpty());
}

}  // namespace shared_lines_test
}  // namespace drydock::rig_config::test
