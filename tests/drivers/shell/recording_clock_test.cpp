// The clock that one device tells holds for the whole file.
#include "drivers/shell/recording_clock.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tests/drivers/link/scripted_adapter.hpp"

namespace drydock::shell {
namespace recording_clock_test {

using device::Kind;
using device::Travels;

std::string sentence(const std::string& body) {
  unsigned sum = 0;
  for (const char c : body) sum ^= static_cast<unsigned char>(c);
  return fmt::format("${}*{:02X}\r\n", body, sum);
}

/// Ten minutes of a ship's line: each second a fix, and four headings between two fixes.
constexpr int duration_s = 600;
std::string ships_line() {
  std::string text;
  for (int t = 0; t < duration_s; ++t) {
    text += sentence(fmt::format("GPRMC,12{:02}{:02}.00,A,4130.0,N,07042.0,W,3.9,0.0,280224,,,A",
                                 t / 60, t % 60));
    for (int i = 0; i < 4; ++i) text += sentence("HEHDT,10.0,T");
  }
  return text;
}

device::DriverOptions driver(Kind kind) {
  device::DriverOptions options;
  options.kind = kind;
  options.protocol = "nmea0183";
  return options;
}

class ClockOfAShipsLine : public testing::Test {
 protected:
  RecordingClock clock(std::vector<device::DriverOptions> drivers, const std::string& keys = "") {
    const std::string path = folder.file("ship.nmea");
    std::ofstream(path) << ships_line();
    return clock_of(*link::parse_uri("file:" + path + keys), drivers, Travels::as_bytes);
  }
  link::testing::Folder folder;
};

TEST_F(ClockOfAShipsLine, IsThatOfTheReceiverForTheCompassToo) {
  for (const auto& drivers : {std::vector{driver(Kind::gnss), driver(Kind::attitude)},
                              std::vector{driver(Kind::attitude), driver(Kind::gnss)}}) {
    const auto times = clock(drivers);
    EXPECT_EQ(times.pace, Pace::device);
    EXPECT_NEAR(times.seconds(), duration_s, 1);
    // Each second has four headings: they come a quarter of it apart.
    for (std::size_t i = 0; i <= 4 * (duration_s - 1); ++i)
      ASSERT_NEAR(
          measurement::seconds(times.times.messages.at(i).at - times.times.messages.front().at),
          static_cast<double>(i) / 4, 1e-6);
  }
}

TEST_F(ClockOfAShipsLine, IsThatOfTheReceiverWhereOnlyTheCompassIsRead) {
  const auto times = clock({driver(Kind::attitude)});
  EXPECT_EQ(times.pace, Pace::device);
  EXPECT_NEAR(times.seconds(), duration_s, 1);
  EXPECT_EQ(times.in_words(), "times: of the clock that a GNSS receiver on its line tells");
  EXPECT_FALSE(times.usual_rate_hz()) << "the rate of the receiver is not that of the compass";
}

TEST_F(ClockOfAShipsLine, IsTheLinesRateWhereTheUriSaysSo) {
  EXPECT_EQ(clock({driver(Kind::gnss), driver(Kind::attitude)}, "?clock=line").pace, Pace::line);
}

}  // namespace recording_clock_test
}  // namespace drydock::shell
