#include <gtest/gtest.h>

#include <map>
#include <numeric>

#include "drivers/wire/ubx/ubx_nmea.hpp"
#include "tests/drivers/wire/gpsd_logs.hpp"

/// Lines with UBX, NMEA 0183 and RTCM 3 in turn. The test counts the frames again with a scanner
/// that tries every byte. It is written from the documents and not from our scanners.
namespace drydock::wire::testing {
namespace mixed_line_test {

struct Count {
  std::size_t ubx = 0, nmea = 0, rtcm = 0;
  std::size_t all() const { return ubx + nmea + rtcm; }
  bool mixed() const { return (ubx > 0) + (nmea > 0) + (rtcm > 0) > 1; }
  friend bool operator==(const Count&, const Count&) = default;
  friend void PrintTo(const Count& c, std::ostream* out) {
    *out << c.ubx << " UBX, " << c.nmea << " NMEA, " << c.rtcm << " RTCM";
  }
};

std::size_t ubx_at(Bytes b) {
  if (b.size() < 8 || b[0] != 0xB5 || b[1] != 0x62) return 0;
  const std::size_t size = b[4] + 256u * b[5] + 8;
  if (size > b.size()) return 0;
  unsigned a = 0, sum = 0;
  for (const auto byte : b.subspan(2, size - 4)) sum = (sum + (a = (a + byte) % 256)) % 256;
  return b[size - 2] == a && b[size - 1] == sum ? size : 0;
}

std::size_t nmea_at(Bytes b) {
  if (b.empty() || (b[0] != '$' && b[0] != '!')) return 0;
  const std::string_view text = as_text(b.first(std::min<std::size_t>(b.size(), 1000)));
  const std::size_t star = text.find_first_of("*$\r\n", 1);
  if (star == text.npos || text[star] != '*' || star + 3 > text.size()) return 0;
  const std::string digits{text.substr(star + 1, 2)};
  if (digits.find_first_not_of("0123456789abcdefABCDEF") != digits.npos) return 0;
  const int sum = std::accumulate(text.begin() + 1, text.begin() + static_cast<long>(star), 0,
                                  [](int x, char c) { return x ^ c; });
  return std::stoi(digits, nullptr, 16) == (sum & 0xFF) ? star + 3 : 0;
}

/// CRC-24Q by long division, one bit at a time.
std::size_t rtcm_at(Bytes b) {
  if (b.size() < 6 || b[0] != 0xD3 || b[1] > 3) return 0;
  const std::size_t size = 256u * b[1] + b[2] + 6;
  if (size > b.size()) return 0;
  unsigned rest = 0;
  for (std::size_t bit = 0; bit < 8 * size; ++bit) {
    rest = rest << 1 | (b[bit / 8] >> (7 - bit % 8) & 1u);
    if ((rest & 0x100'0000) != 0) rest ^= 0x186'4CFB;
  }
  return rest == 0 ? size : 0;
}

Count count_by_every_byte(Bytes bytes) {
  Count count;
  while (!bytes.empty()) {
    std::size_t step = 1;
    if (const auto n = ubx_at(bytes)) {
      ++count.ubx, step = n;
    } else if (const auto m = nmea_at(bytes)) {
      ++count.nmea, step = m;
    } else if (const auto r = rtcm_at(bytes)) {
      ++count.rtcm, step = r;
    }
    bytes = bytes.subspan(step);
  }
  return count;
}

Count count_of(const Reading<UbxNmea>& reading) {
  Count count;
  for (const Buffer& frame : reading.frames) {
    ++(frame[0] == '$' || frame[0] == '!' ? count.nmea : frame[0] == 0xD3 ? count.rtcm : count.ubx);
  }
  return count;
}

/// A capture may end inside a frame. The added bytes let the framer give up an incomplete frame.
Buffer with_quiet_end(Buffer bytes) { return bytes + Buffer(UbxNmea::max_frame, 0x00); }

class MixedLine : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(corpora())) GTEST_SKIP() << "no captures at " << corpora();
  }
  static std::vector<std::filesystem::path> logs() {
    auto all = gpsd_logs();
    for (const auto& entry : std::filesystem::directory_iterator{corpora() / "gps/pyubx2"}) {
      if (entry.path().extension() == ".log") all.push_back(entry.path());
    }
    return all;
  }
  static Count count(const std::string& name) {
    return count_of(
        read_stream<UbxNmea>(with_quiet_end(read_file(corpora() / "gps/pyubx2" / name))));
  }
};

TEST_F(MixedLine, EveryFrameOfEveryProtocolIsFoundInEveryLogWhateverItsPieces) {
  std::size_t mixed = 0;
  for (const auto& log : logs()) {
    const Buffer bytes = with_quiet_end(gpsd_log(log));
    const Count expected = count_by_every_byte(bytes);
    if (!expected.mixed()) continue;
    ++mixed;
    const auto whole = read_stream<UbxNmea>(bytes);
    EXPECT_EQ(count_of(whole), expected) << log;
    for (const std::size_t piece : {1, 2, 3, 7, 97}) {
      const auto split = read_stream<UbxNmea>(bytes, {piece});
      EXPECT_EQ(split.frames, whole.frames) << log << " in pieces of " << piece;
      EXPECT_EQ(split.counters, whole.counters) << log << " in pieces of " << piece;
    }
  }
  EXPECT_EQ(mixed, 8u);
}

TEST_F(MixedLine, WhatIsDamagedOrCutCostsNothingElse) {
  EXPECT_EQ(count("pygpsdata-MIXED-RTCM3BADCRC.log"), (Count{1, 2, 6}));
  EXPECT_EQ(count("pygpsdata-MIXED3BADCK.log"), (Count{1, 3, 0}));
  EXPECT_EQ(count("pygpsdata-MIXED2.log"), (Count{26, 28, 0}));
  EXPECT_EQ(count("pygpsdata-BADEOF1.log"), (Count{3, 0, 0}));
  EXPECT_EQ(count("pygpsdata-BADEOF3.log"), (Count{2, 0, 0}));
  EXPECT_EQ(count("pygpsdata-BADNMEAEOF.log"), (Count{2, 3, 0}));
  EXPECT_EQ(count("pygpsdata-NMEABADEND.log"), (Count{0, 16, 0}));
}

}  // namespace mixed_line_test
}  // namespace drydock::wire::testing
