// Logs of sentences with the logger's times are replayed by them.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "drivers/decode/replay.hpp"

namespace drydock::decode {
namespace logged_times_test {

using shell::Pace;

struct Replayed {
  Pace pace = Pace::line;
  std::vector<double> received_at_s;
};

/// Replays the lines; `$GPHDT,75.5664,T*36` is the example of a manual.
Replayed replay_of(const std::string& log, const std::string& kind) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / "logged_times_test.log";
  std::ofstream(file) << log;
  ReplayOptions options;
  options.capture = file.string();
  options.protocol = "nmea0183";
  options.kind = kind;
  Replayed replayed;
  replayed.pace = play(options, [&](const measurement::Measurement& m) {
                    const auto& origin = measurement::origin_of(m);
                    replayed.received_at_s.push_back(
                        measurement::seconds(origin.received_at.time_since_epoch()));
                  }).clock.pace;
  return replayed;
}

TEST(LoggedTimes, AreTheTimesOfMeasurementsOfADeviceWithoutAClock) {
  const auto replayed = replay_of(
      "2023-12-31T23:59:30.100Z $GPHDT,75.5664,T*36\r\n2023-12-31T23:59:30.350Z "
      "$GPHDT,75.5664,T*36\r\n"
      "2023-12-31T23:59:37.000Z $GPHDT,75.5664,T*36\r\n",
      "attitude");
  EXPECT_EQ(replayed.pace, Pace::arrival);
  ASSERT_EQ(replayed.received_at_s.size(), 3u);
  EXPECT_NEAR(replayed.received_at_s[0], 1704067170.1, 1e-6);
  EXPECT_NEAR(replayed.received_at_s[1], 1704067170.35, 1e-6);
  EXPECT_NEAR(replayed.received_at_s[2], 1704067177.0, 1e-6);
}

/// A receiver tells UTC to the hundredth, so whole seconds of a logger tell less.
TEST(LoggedTimes, OfWholeSecondsGiveWayToTheDevicesClock) {
  const auto log = [](const char* begin) {
    std::string text;
    for (const char* sentence :
         {"$GPRMC,123519.20,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W*46",
          "$GPRMC,123519.40,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W*40",
          "$GPRMC,123519.60,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W*42"})
      text += std::string(begin) + sentence + "\r\n";
    return text;
  };
  EXPECT_EQ(replay_of(log("1994-03-23 12:35:19 "), "gnss").pace, Pace::device);
  EXPECT_EQ(replay_of(log("1994-03-23 12:35:19.25 "), "gnss").pace, Pace::arrival);
}

}  // namespace logged_times_test
}  // namespace drydock::decode
