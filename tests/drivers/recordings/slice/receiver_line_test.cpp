#include "drivers/recordings/slice/receiver_line.hpp"

#include <gtest/gtest.h>

#include <string>

namespace drydock::slice {
namespace receiver_line_test {

using measurement::Stamp;

// The sentence of the NMEA 0183 standard's GLL example form; XOR of its characters is 31h.
constexpr std::string_view position = "$GPGLL,4916.45,N,12311.12,W,225444,A*31\r\n";

wire::Bytes bytes_of(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

class OneReceiver : public testing::Test {
 protected:
  /// When messages came out, one entry a read.
  void note(const std::vector<ReceiverLine::Moved>& moved) {
    for (const auto& read : moved) times.push_back(read.at);
  }

  Displacement place{measurement::Geodetic{}};
  Dropped dropped;
  ReceiverLine line{place, dropped};
  std::vector<Stamp> times;
};

/// The header of a NAV-PVT whose length says 1116 bytes instead of 92; the rest of it is lost.
constexpr std::string_view damaged("\xB5\x62\x01\x07\x5C\x04", 6);

TEST_F(OneReceiver, MessagesBehindADamagedLengthKeepTheTimesOfTheirReads) {
  std::vector<Stamp> expected;
  line.move(bytes_of(damaged), Stamp{});
  for (int i = 1; i <= 5; ++i) {
    expected.push_back(Stamp{std::chrono::milliseconds{200 * i}});
    note(line.move(bytes_of(position), expected.back()));
  }
  EXPECT_EQ(times, expected);
  EXPECT_EQ(line.moved(), 5U);
  EXPECT_EQ(dropped.at("bytes outside of messages"), damaged.size());
}

TEST_F(OneReceiver, MessagesBehindADamagedLengthAreNotLostAtTheEnd) {
  line.move(bytes_of(damaged), Stamp{});
  note(line.move(bytes_of(position), Stamp{std::chrono::milliseconds{100}}));
  EXPECT_TRUE(times.empty());
  note(line.finish());
  EXPECT_EQ(times, std::vector{Stamp{std::chrono::milliseconds{100}}});
}

}  // namespace receiver_line_test
}  // namespace drydock::slice
