#include "drivers/host/status_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace status_line_test {

using drydock::host::RunStanding;
using drydock::host::standing_lines;
using testing::ElementsAre;

RunStanding recording() {
  RunStanding standing;
  standing.elapsed_s = 12;
  standing.duration_s = 60;
  standing.recorded = 2'340'000;
  standing.rates_hz = {{"dvl", 5}, {"imu", 99.98}};
  return standing;
}

TEST(StatusLine, ARecordingTellsTimeSizeAndTheRateOfEachDevice) {
  EXPECT_THAT(standing_lines(recording(), 80),
              ElementsAre("12 s of 60 s, 48 s left  2.3 MB  dvl 5.00 Hz  imu 99.98 Hz"));
}

TEST(StatusLine, ARunWithoutAnEndTellsOnlyWhatPassed) {
  RunStanding standing;
  standing.elapsed_s = 7;
  EXPECT_THAT(standing_lines(standing, 80), ElementsAre("7 s"));
}

TEST(StatusLine, ALineLongerThanTheTerminalIsCut) {
  RunStanding standing = recording();
  standing.rates_hz.clear();
  EXPECT_THAT(standing_lines(standing, 24), ElementsAre("12 s of 60 s, 48 s left "));
}

TEST(StatusLine, ADeviceThatDoesNotFitIsOnTheNextLineAndNoneIsLeftOut) {
  EXPECT_THAT(standing_lines(recording(), 55),
              ElementsAre("12 s of 60 s, 48 s left  2.3 MB  dvl 5.00 Hz", "  imu 99.98 Hz"));
}

}  // namespace status_line_test
