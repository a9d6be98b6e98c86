#include "hil/replay/recording_progress.hpp"

#include <gmock/gmock.h>

namespace drydock::replay {
namespace recording_progress_test {

using testing::ElementsAre;

TEST(RecordingProgress, TellsTimeGoneTimeLeftSizeAndTheRateOfEachDevice) {
  host::RunStanding standing;
  standing.elapsed_s = 12;  // a quarter is done: three more of these
  standing.recorded = 2'340'000;
  standing.rates_hz = {{"dvl", 5}, {"imu", 99.98}};
  EXPECT_THAT(progress_lines("replay", 0.25, standing, 120),
              ElementsAre("replay [#######.......................] 25 %, 12 s, 36 s left  2.3 MB  "
                          "dvl 5.00 Hz  imu 99.98 Hz  Ctrl-C ends"));
  EXPECT_THAT(progress_lines("replay", 0.25, standing, 79),
              ElementsAre("replay [#######.......................] 25 %, 12 s, 36 s left  2.3 MB",
                          "  dvl 5.00 Hz  imu 99.98 Hz  Ctrl-C ends"));
}

TEST(RecordingProgress, OfNothingYetDoneTellsNoTimeLeft) {
  EXPECT_THAT(progress_lines("cut", 0, {}, 79),
              ElementsAre("cut [..............................] 0 %, 0 s  Ctrl-C ends"));
}

}  // namespace recording_progress_test
}  // namespace drydock::replay
