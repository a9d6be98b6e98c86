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

std::string polled_on(const std::string& link, const std::string& name,
                      const std::string& protocol) {
  return "[[device]]\nname = \"" + name + "\"\nkind = \"depth\"\nprotocol = \"" + protocol +
         "\"\nlink = \"" + link + "\"\n";
}

TEST(RigProblems, TwoChannelsOfOneUnitWhoseAnswersAreAlikeHaveNoLinkInCommon) {
  const std::string line = "serial:/dev/ttyUSB0?baud=9600";
  const auto first = polled_on(line, "p1", "keller.toml");
  EXPECT_THAT(problems_of(first + polled_on(line, "tob1", "keller-tob1.toml")),
              ElementsAre("r.toml:17:8: /device/2/link: 'p1' asks on this link too, and the "
                          "answers to both begin alike, so that nobody can tell whose they are, "
                          "allowed: a link of its own"));
  EXPECT_THAT(
      problems_of(first + polled_on("serial:/dev/ttyUSB1?baud=9600", "tob1", "keller-tob1.toml")),
      IsEmpty());
  EXPECT_THAT(problems_of(first + polled_on(line, "digiquartz", "digiquartz.toml")), IsEmpty());
}

}  // namespace shared_lines_test
}  // namespace drydock::rig_config::test
