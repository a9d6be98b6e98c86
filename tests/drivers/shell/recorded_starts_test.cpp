#include "drivers/shell/recorded_starts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace drydock::shell {
namespace {

using measurement::Stamp;
using std::chrono::hours;
using std::chrono::seconds;

const Stamp dive{hours{24 * 365 * 55}}, start{hours{1}};

RecordingClock clock(Pace pace, Stamp first) { return {.pace = pace, .first = first}; }

TEST(RecordedStarts, CapturesOfOneDiveKeepTheirDistances) {
  const std::vector clocks{clock(Pace::arrival, dive + seconds{12}), clock(Pace::arrival, dive)};
  EXPECT_THAT(recorded_starts(clocks, start), testing::ElementsAre(start + seconds{12}, start));
}

TEST(RecordedStarts, CapturesOfDifferentDaysAndThoseWithoutTimesOfArrivalBeginTogether) {
  const std::vector clocks{clock(Pace::arrival, dive), clock(Pace::arrival, dive + hours{48}),
                           clock(Pace::device, dive + seconds{5}), clock(Pace::line, Stamp{})};
  EXPECT_THAT(recorded_starts(clocks, start), testing::Each(start));
}

}  // namespace
}  // namespace drydock::shell
