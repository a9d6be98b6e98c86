#include "hil/bench/told_log.hpp"

#include <gmock/gmock.h>

namespace drydock::bench {
namespace told_log_test {

TEST(ToldLog, SaysWhatADeviceWasToldInOneLineTheLastAtTheEnd) {
  ToldLog log;
  EXPECT_EQ(log.add("gnss", "rate 5 Hz"), "gnss was told rate 5 Hz");
  log.add("dvl", "something else");
  log.add("gnss", "saves settings");
  EXPECT_EQ(log.latest("gnss"), "rate 5 Hz; saves settings");
  EXPECT_EQ(log.add("gnss", "rate 5 Hz"), "") << "a person has read it";
  EXPECT_EQ(log.latest("gnss"), "saves settings; rate 5 Hz") << "the rate is not saved";
  EXPECT_EQ(log.latest("imu"), "");
}

TEST(ToldLog, OfManyLinesKeepsTheLastOnesAndSaysHowManyWereBefore) {
  ToldLog log;
  for (int i = 0; i < 20; ++i) log.add("gnss", "message " + std::to_string(i));
  EXPECT_THAT(log.latest("gnss"), testing::StartsWith("(4 before); message 4; message 5;"));
  EXPECT_THAT(log.latest("gnss"), testing::EndsWith("; message 19"));
}

}  // namespace told_log_test
}  // namespace drydock::bench
