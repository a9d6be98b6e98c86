#include <gtest/gtest.h>

#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "drivers/wire/passed_over.hpp"
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

/// An AIS message as its documents show it, and one that was cut in front of another sentence.
TEST(Nmea0183Line, AnEncapsulationSentenceIsAFrameWithoutAMessage) {
  const std::string ais = "!AIVDM,1,1,,B,177KQJ5000G?tO`K>RA1wUbN0TKH,0*5C\r\n";
  const std::string vtg = "$GPVTG,054.7,T,034.4,M,005.5,N,010.2,K*48\r\n";
  const auto read = read_stream<Nmea0183>(
      as_bytes(ais + vtg + ais.substr(0, 20) + vtg + "\\s:GPS1,c:1704067170*4C\\" + ais));
  EXPECT_EQ(read.all<Vtg>().size(), 2u);
  EXPECT_EQ(read.counters.frames, 4u);
  EXPECT_EQ(read.counters.bytes_skipped, 20u);
  EXPECT_EQ(frame_name(as_bytes(ais)), "!AIVDM");
}

TEST(Nmea0183Line, AnEncapsulationSentenceWithAWrongChecksumIsCounted) {
  const auto read =
      read_stream<Nmea0183>(as_bytes("!AIVDM,1,1,,B,177KQJ5000G?tO`K>RA1wUbN0TKH,0*5D\r\n"));
  EXPECT_EQ(read.counters.frames, 0u);
  EXPECT_EQ(read.counters.bad_checksums, 1u);
}

TEST(Nmea0183Line, ATerminalsSecondCarriageReturnIsPartOfTheLineEnd) {
  const std::string line = "$GPVTG,054.7,T,034.4,M,005.5,N,010.2,K*48\r\r\n";
  const auto read = read_stream<Nmea0183>(as_bytes(line + line));
  EXPECT_EQ(read.all<Vtg>().size(), 2u);
  EXPECT_EQ(read.counters.bytes_skipped, 0u);
}

}  // namespace nmea0183_tag_test
}  // namespace drydock::wire::testing
