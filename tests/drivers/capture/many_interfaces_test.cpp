// A damaged file names thousands of interfaces, and readers keep a state of each.
#include <gmock/gmock.h>

#include "drivers/capture/frame_capture.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

namespace drydock::capture {
namespace many_interfaces_test {

using ::testing::HasSubstr;

TEST(FrameCapture, GivesFramesOf256InterfacesAndCountsTheOthers) {
  std::string log;
  for (int round = 0; round < 2; ++round)
    for (int i = 0; i < 300; ++i)
      log += "(" + std::to_string(round * 300 + i) + ".0) can" + std::to_string(i) +
             " 18EEFF01#05A04FFA008296C0\n";
  FrameCapture capture;
  capture.feed(wire::testing::as_bytes(log));
  capture.finish();
  std::size_t given = 0;
  while (const auto record = capture.next()) ++given;
  EXPECT_EQ(given, 512u);
  EXPECT_EQ(capture.tally().frames, 512u);
  EXPECT_EQ(capture.tally().left_out, 88u);
  EXPECT_EQ(capture.tally().damaged, 0u);
  EXPECT_THAT(damage_text(capture.tally()), HasSubstr("88 frames of more than 256 interfaces"));
}

}  // namespace many_interfaces_test
}  // namespace drydock::capture
