#include <gtest/gtest.h>

#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

/// What stands around sentences on a line: TAG blocks, line ends of terminals.
namespace drydock::wire::testing {
namespace nmea0183_tag_test {

// Lines of a logger. The checksum of a TAG block is the XOR of what stands between its marks.
TEST(Nmea0183Line, ATagBlockIsPartOfItsSentence) {
  constexpr std::string_view line =
      "\\s:GPS1,c:1704067170*4C\\$GPVTG,054.7,T,034.4,M,005.5,N,010.2,K*48\r\n";
  std::string text;
  for (int i = 0; i < 3; ++i) text += line;
  const auto read = read_stream<Nmea0183>(as_bytes(text));
  EXPECT_EQ(read.all<Vtg>().size(), 3u);
  EXPECT_EQ(read.counters.bytes_skipped, 0u);
  EXPECT_EQ(read.counters.frames, 3u);
}

TEST(Nmea0183Line, ADamagedTagBlockDoesNotCostTheSentence) {
  for (const std::string_view tag : {"\\s:GPS1,c:1704067170*4D\\", "\\s:GPS1*4C", "\\", "\\\\"}) {
    const std::string text = std::string(tag) + "$GPVTG,054.7,T,034.4,M,005.5,N,010.2,K*48\r\n";
    const auto read = read_stream<Nmea0183>(as_bytes(text));
    EXPECT_EQ(read.all<Vtg>().size(), 1u) << tag;
    EXPECT_EQ(read.counters.bytes_skipped, tag.size()) << tag;
  }
}

TEST(Nmea0183Line, ATerminalsSecondCarriageReturnIsPartOfTheLineEnd) {
  const std::string line = "$GPVTG,054.7,T,034.4,M,005.5,N,010.2,K*48\r\r\n";
  const auto read = read_stream<Nmea0183>(as_bytes(line + line));
  EXPECT_EQ(read.all<Vtg>().size(), 2u);
  EXPECT_EQ(read.counters.bytes_skipped, 0u);
}

}  // namespace nmea0183_tag_test
}  // namespace drydock::wire::testing
