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
  std::string words;
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
  const auto played = play(options, [&](const measurement::Measurement& m) {
    const auto& origin = measurement::origin_of(m);
    replayed.received_at_s.push_back(measurement::seconds(origin.received_at.time_since_epoch()));
  });
  replayed.pace = played.clock.pace;
  replayed.words = played.clock.in_words();
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

/// RMC of 2019-03-26, stamped half a second after its time, over midnight.
TEST(LoggedTimes, WithoutADateHaveThatOfTheReceiver) {
  std::string log;
  for (const char* line :
       {"23:59:58.500 $GPRMC,235958,A,5307.0082,S,06724.6187,W,012.2,133.6,260319,010.7,E*72",
        "23:59:59.500 $GPRMC,235959,A,5307.0082,S,06724.6187,W,012.2,133.6,260319,010.7,E*73",
        "00:00:00.500 $GPRMC,000000,A,5307.0082,S,06724.6187,W,012.2,133.6,270319,010.7,E*73"})
    log += std::string(line) + "\r\n";
  const auto replayed = replay_of(log, "gnss");
  EXPECT_EQ(replayed.pace, Pace::arrival);
  ASSERT_EQ(replayed.received_at_s.size(), 3u);
  constexpr double midnight_s = 1553644800;  // date -u -d 2019-03-27 +%s
  EXPECT_NEAR(replayed.received_at_s[0], midnight_s - 1.5, 1e-6);
  EXPECT_NEAR(replayed.received_at_s[2], midnight_s + 0.5, 1e-6);
  EXPECT_EQ(replayed.words,
            "times: of the capture, which tells no date: it is that of a GNSS receiver in it");
}

TEST(LoggedTimes, WithoutADateAndAReceiverSayThatNobodyTellsIt) {
  const auto replayed = replay_of(
      "23:59:30.100 $GPHDT,75.5664,T*36\r\n23:59:30.350 $GPHDT,75.5664,T*36\r\n"
      "00:00:00.000 $GPHDT,75.5664,T*36\r\n",
      "attitude");
  ASSERT_EQ(replayed.received_at_s.size(), 3u);
  EXPECT_NEAR(replayed.received_at_s[2], 86400, 1e-6);
  EXPECT_EQ(replayed.words,
            "times: of the capture, which tells no date: they count from the midnight before the "
            "first one, as if that were 1970-01-01");
}

/// A Magellan 315: its GLL has milliseconds, its RMC the same time cut to hundredths.
TEST(LoggedTimes, OfADevicesClockThatIsCutShorterAreTimes) {
  std::string log;
  for (const char* line :
       {"$GPGLL,3908.8199,N,00023.0832,W,120824.758,A*22",
        "$GPRMC,120824.75,A,3908.8199,N,00023.0832,W,00.0,000.0,130305,01.,W*61",
        "$GPGLL,3908.8200,N,00023.0832,W,120826.760,A*28",
        "$GPRMC,120826.76,A,3908.8200,N,00023.0832,W,00.0,000.0,130305,01.,W*63",
        "$GPGLL,3908.8201,N,00023.0832,W,120828.763,A*24",
        "$GPRMC,120828.76,A,3908.8199,N,00023.0832,W,00.0,000.0,130305,01.,W*6E"})
    log += std::string(line) + "\r\n";
  const auto replayed = replay_of(log, "gnss");
  EXPECT_EQ(replayed.pace, Pace::device);
  ASSERT_EQ(replayed.received_at_s.size(), 3u);
  EXPECT_NEAR(replayed.received_at_s[2] - replayed.received_at_s[0], 4.005, 1e-3);
}

}  // namespace logged_times_test
}  // namespace drydock::decode
