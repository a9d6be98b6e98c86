#include <gmock/gmock.h>

#include "tests/drivers/capture/captures.hpp"

/// The log of the Open Vehicle Monitoring System.
namespace drydock::capture::testing {
namespace crtd_test {

using namespace std::chrono_literals;

TEST(CrtdFile, HasFramesOfBothLengthsOfIdentifierAndRemarks) {
  const Outcome outcome = read_capture(
      "1542473901.020305 CXX OVMS CRTD\n"
      "1542473901.020305 1R11 7ED 04 41 0C\r\n"
      "1542473901.021 2T29 18EEFF01 01 02 03 04 05 06 07 08\n"
      "1542473901.022 R11 100\n"
      "211.572 CEV Event vehicle.on\n"
      "1542473901.023 1R11 800 01\n");
  ASSERT_EQ(outcome.records.size(), 3u);
  EXPECT_EQ(outcome.damaged, 1u) << "800 has 12 bits";
  EXPECT_EQ(outcome.records[0].time.value(), 1542473901020305us);
  EXPECT_EQ(outcome.records[0].interface, "can0");
  EXPECT_EQ(outcome.records[0].frame.id, 0x7EDu);
  EXPECT_EQ(outcome.records[0].frame.size, 3);
  EXPECT_EQ(outcome.records[0].frame.data[1], 0x41);
  EXPECT_FALSE(outcome.records[0].frame.extended);
  EXPECT_EQ(outcome.records[1].interface, "can1");
  EXPECT_EQ(outcome.records[1].frame.id, 0x18EEFF01u);
  EXPECT_TRUE(outcome.records[1].frame.extended);
  EXPECT_EQ(outcome.records[1].frame.size, 8);
  EXPECT_EQ(outcome.records[2].frame.size, 0);
}

}  // namespace crtd_test
}  // namespace drydock::capture::testing
