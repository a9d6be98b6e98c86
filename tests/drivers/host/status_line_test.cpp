#include "drivers/host/status_line.hpp"

#include <gtest/gtest.h>

namespace status_line_test {

using drydock::host::RunStanding;
using drydock::host::standing_text;

RunStanding recording() {
  RunStanding standing;
  standing.elapsed_s = 12;
  standing.duration_s = 60;
  standing.recorded = 2'340'000;
  standing.rates_hz = {{"dvl", 5}, {"imu", 99.98}};
  return standing;
}

TEST(StatusLine, ARecordingTellsTimeSizeAndTheRateOfEachDevice) {
  EXPECT_EQ(standing_text(recording(), 80),
            "12 s of 60 s, 48 s left  2.3 MB  dvl 5.00 Hz  imu 99.98 Hz");
}

TEST(StatusLine, ARunWithoutAnEndTellsOnlyWhatPassed) {
  RunStanding standing;
  standing.elapsed_s = 7;
  EXPECT_EQ(standing_text(standing, 80), "7 s");
}

TEST(StatusLine, ALineLongerThanTheTerminalIsCut) {
  EXPECT_EQ(standing_text(recording(), 24), "12 s of 60 s, 48 s left ");
}

TEST(StatusLine, NoRateIsCutInTheMiddleOfItsNumber) {
  EXPECT_EQ(standing_text(recording(), 55), "12 s of 60 s, 48 s left  2.3 MB  dvl 5.00 Hz");
}

}  // namespace status_line_test
