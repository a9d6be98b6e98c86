#include "drivers/shell/recorded_starts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace drydock::shell {
namespace {

using measurement::Stamp;
using std::chrono::hours;
using std::chrono::seconds;

const Stamp dive{hours{24 * 365 * 55}}, start{hours{1}};

PlayedFile file(Pace pace, Stamp first) {
  PlayedFile played;
  played.clock.pace = pace;
  played.clock.first = first;
  return played;
}

TEST(RecordedStarts, CapturesOfOneDiveKeepTheirDistances) {
  const std::vector files{file(Pace::arrival, dive + seconds{12}), file(Pace::arrival, dive)};
  EXPECT_THAT(recorded_starts(files, start), testing::ElementsAre(start + seconds{12}, start));
}

TEST(RecordedStarts, CapturesOfDifferentDaysAndThoseWithoutTimesOfArrivalBeginTogether) {
  const std::vector files{file(Pace::arrival, dive), file(Pace::arrival, dive + hours{48}),
                          file(Pace::device, dive + seconds{5}), file(Pace::line, Stamp{})};
  EXPECT_THAT(recorded_starts(files, start), testing::Each(start));
}

}  // namespace
}  // namespace drydock::shell
