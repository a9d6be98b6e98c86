// Recordings without times of arrival are replayed by the device's own clock.
#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "drivers/decode/replay.hpp"
#include "tests/drivers/decode/corpora.hpp"

namespace drydock::decode {
namespace device_clock_test {

using namespace corpora;

struct Replayed {
  shell::RecordingClock clock;
  std::vector<double> received_at_s;
};

Replayed play_file(const fs::path& file, const std::string& protocol, const std::string& kind = "",
                   const std::string& clock = "") {
  ReplayOptions options;
  options.capture = file.string();
  options.protocol = protocol;
  options.kind = kind;
  options.clock = clock;
  Replayed replayed;
  replayed.clock = play(options, [&](const measurement::Measurement& m) {
                     const auto& origin = measurement::origin_of(m);
                     replayed.received_at_s.push_back(
                         measurement::seconds(origin.received_at.time_since_epoch()));
                   }).clock;
  return replayed;
}

/// Each ensemble of the AUV's dive comes when its clock says, as another program reads it.
TEST_F(Corpora, EnsemblesOfADiveComeWhenTheInstrumentsClockSays) {
  const auto replayed = play_file(root_ / "dvl/pd0/raw/remus_20141219_a.adc", "pd0");
  EXPECT_EQ(replayed.clock.pace, shell::Pace::device);
  std::istringstream rows(read_file(root_ / "dvl/pd0/expected/remus_20141219_a.jsonl"));
  std::size_t row = 0;
  for (std::string text; std::getline(rows, text); ++row) {
    ASSERT_LT(row, replayed.received_at_s.size());
    EXPECT_NEAR(replayed.received_at_s[row], json::parse(text)["time"].get<double>(), 0.005) << row;
  }
  EXPECT_EQ(row, 1934u);
}

/// The README of the dive: an ensemble every 2.03 s.
TEST_F(Corpora, TheUsualRateOfADiveIsThatOfItsClock) {
  const auto replayed = play_file(root_ / "dvl/pd0/raw/remus_20141219_a.adc", "pd0");
  EXPECT_NEAR(replayed.clock.usual_rate_hz().value(), 1 / 2.03, 0.005);
}

TEST_F(Corpora, WithClockLineBytesFollowAtTheLinesRate) {
  const auto replayed = play_file(root_ / "dvl/pd0/raw/remus_20141219_a.adc", "pd0", "", "line");
  EXPECT_EQ(replayed.clock.pace, shell::Pace::line);
  EXPECT_NEAR(replayed.received_at_s.back(), 835'488 * 10 / 9600.0, 0.1);
}

/// SOURCES.md of the captures: all times of the autopilot lie within 56 ms.
TEST_F(Corpora, AnAutopilotsWorthlessTimesAreNotTaken) {
  const auto file = root_ / "n2k/canboat/samples/raymarine-ev1.head.raw";
  const auto replayed = play_file(file, "nmea2000", "attitude");
  EXPECT_EQ(replayed.clock.pace, shell::Pace::line);
  EXPECT_FALSE(replayed.clock.usual_rate_hz());
}

/// A boat's bus whose logger kept times: 05:05:27.966 to 05:06:50.886 UTC.
TEST_F(Corpora, ABoatsBusKeepsItsTimesOfArrival) {
  const auto file = root_ / "n2k/canboat/samples/furuno-130842-figure8-fast.head.raw";
  const auto replayed = play_file(file, "nmea2000", "attitude");
  EXPECT_EQ(replayed.clock.pace, shell::Pace::arrival);
  const auto [first, last] = std::ranges::minmax(replayed.received_at_s);
  EXPECT_NEAR(last - first, 82.9, 1);
}

/// Two sentences of a receiver, of one and of the next second, and one of the second behind them.
TEST(DeviceClock, AReceiversUtcPacesSentencesWithoutTimes) {
  const TemporaryFile file(
      "$GPGGA,235959.00,3600.0000,N,12900.0000,E,1,08,1.0,10.0,M,20.0,M,,*58\r\n"
      "$GPGGA,000000.00,3600.0000,N,12900.0000,E,1,08,1.0,10.0,M,20.0,M,,*59\r\n"
      "$GPGGA,000001.00,3600.0000,N,12900.0000,E,1,08,1.0,10.0,M,20.0,M,,*58\r\n"
      "$GPGGA,000005.00,3600.0000,N,12900.0000,E,1,08,1.0,10.0,M,20.0,M,,*5C\r\n");
  const auto replayed = play_file(file.path(), "nmea0183", "gnss");
  EXPECT_EQ(replayed.clock.pace, shell::Pace::device);
  ASSERT_EQ(replayed.received_at_s.size(), 4u);
  for (std::size_t i = 1; i < 4; ++i)
    EXPECT_NEAR(replayed.received_at_s[i] - replayed.received_at_s[0], i < 3 ? i : 6, 1e-3) << i;
}

}  // namespace device_clock_test
}  // namespace drydock::decode
