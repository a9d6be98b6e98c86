#include <gmock/gmock.h>

#include "tests/drivers/capture/captures.hpp"

/// Times that candump prints on the screen: since the first frame (-t z), or since the one before
/// (-t d).
namespace drydock::capture::testing {
namespace candump_times_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using namespace std::chrono_literals;

std::vector<std::chrono::nanoseconds> times_of(std::string_view text,
                                               const std::vector<std::size_t>& pieces = {1 << 16}) {
  std::vector<std::chrono::nanoseconds> times;
  for (const auto& seen : read_capture(wire::testing::as_bytes(text), pieces).records)
    times.push_back(seen.time.value());
  return times;
}

std::string note_of(std::string_view text) {
  FrameCapture capture;
  capture.feed(wire::testing::as_bytes(text));
  capture.finish();
  while (capture.next()) continue;
  return std::string(capture.note());
}

constexpr std::string_view pauses =
    " (000.000000)  can0  123   [1]  11\n"
    " (000.100000)  can0  124   [1]  11\n"
    " (000.001000)  can0  125   [1]  11\n"
    " (002.000000)  can0  123   [1]  11\n";
constexpr std::string_view since_start =
    " (000.000000)  can0  123   [1]  11\n"
    " (000.100000)  can0  124   [1]  11\n"
    " (000.101000)  can0  125   [1]  11\n"
    " (002.101000)  can0  123   [1]  11\n";

TEST(CandumpTimes, PausesAreSummed) {
  EXPECT_THAT(times_of(pauses), ElementsAre(0ms, 100ms, 101ms, 2101ms));
  EXPECT_THAT(note_of(pauses), HasSubstr("candump -t d"));
}

TEST(CandumpTimes, PausesAreSummedHoweverTheLinesCome) {
  EXPECT_EQ(times_of(pauses, {40, 7}), times_of(pauses));
}

TEST(CandumpTimes, ThoseSinceTheStartStayAsTheyAre) {
  EXPECT_THAT(times_of(since_start), ElementsAre(0ms, 100ms, 101ms, 2101ms));
  EXPECT_THAT(note_of(since_start), HasSubstr("candump -t z"));
}

TEST(CandumpTimes, EqualPausesAreNoSingleMoment) {
  std::string text = " (000.000000)  can0  123   [1]  11\n";
  for (int i = 0; i < 20; ++i) text += " (000.050000)  can0  123   [1]  11\n";
  EXPECT_EQ(times_of(text).back(), 1s);
}

TEST(CandumpTimes, OfTwoBusesMayCrossByWhatTheComputerHoldsThem) {
  constexpr std::string_view text =
      " (000.000000)  can0  123   [1]  11\n"
      " (000.100000)  can0  123   [1]  11\n"
      " (000.099000)  can1  123   [1]  11\n"
      " (000.200000)  can0  123   [1]  11\n";
  EXPECT_THAT(times_of(text), ElementsAre(0ms, 100ms, 99ms, 200ms));
}

TEST(CandumpTimes, OfADateAreNoPauses) {
  constexpr std::string_view text =
      " (1436509052.249713)  can0  123   [1]  11\n"
      " (1436509050.249713)  can0  123   [1]  11\n";  // a clock that was set
  EXPECT_EQ(times_of(text).back(), 1436509050s + 249713us);
  EXPECT_EQ(note_of(text), "");
}

}  // namespace candump_times_test
}  // namespace drydock::capture::testing
