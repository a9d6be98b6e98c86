// Compares receiver logs of gpsd and pyubx2 with scanners that know only checksums.
#include <gtest/gtest.h>

#include <cctype>
#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "tests/drivers/decode/corpora.hpp"

namespace drydock::decode {
namespace gnss_corpora_test {

using namespace corpora;

/// The receiver's output. gpsd's logs begin with lines of '#', and some of these contain sentences.
std::string recorded_by(const fs::path& log) {
  std::string text = read_file(log);
  while (text.starts_with('#')) text.erase(0, text.find('\n') + 1);
  return text;
}

/// Counts every `$ttsss,...*hh` with a right XOR and a formatter that Drydock decodes.
Counts scan_nmea(const std::string& text) {
  static const std::set<std::string> ours{"GGA", "RMC", "GSV", "GSA", "VTG", "ZDA", "GNS", "GLL",
                                          "GST", "HDT", "THS", "HDG", "HDM", "VHW", "VBW", "VLW"};
  Counts counts;
  for (auto at = text.find('$'); at != std::string::npos; at = text.find('$', at + 1)) {
    int sum = 0;
    auto i = at + 1;
    for (; i < text.size() && text[i] >= ' ' && text[i] <= '~' && text[i] != '*' && text[i] != '$';
         ++i)
      sum ^= text[i];
    if (i + 2 >= text.size() || text[i] != '*') continue;
    const std::string hex = text.substr(i + 1, 2);
    if (!std::isxdigit(static_cast<unsigned char>(hex[0])) ||
        !std::isxdigit(static_cast<unsigned char>(hex[1])) || std::stoi(hex, nullptr, 16) != sum)
      continue;
    const std::string address = text.substr(at + 1, text.find_first_of(",*", at) - at - 1);
    if (address.size() == 5 && ours.contains(address.substr(2))) ++counts[address.substr(2)];
  }
  return counts;
}

/// Counts every message that Drydock decodes, with a right Fletcher checksum.
Counts scan_ubx(const std::string& text) {
  static const std::map<int, std::string> ours{
      {0x0102, "NAV-POSLLH"},  {0x0103, "NAV-STATUS"},  {0x0104, "NAV-DOP"},
      {0x0106, "NAV-SOL"},     {0x0107, "NAV-PVT"},     {0x0112, "NAV-VELNED"},
      {0x0120, "NAV-TIMEGPS"}, {0x0121, "NAV-TIMEUTC"}, {0x0130, "NAV-SVINFO"},
      {0x0135, "NAV-SAT"},     {0x0143, "NAV-SIG"},     {0x0161, "NAV-EOE"},
      {0x0213, "RXM-SFRBX"},   {0x0215, "RXM-RAWX"}};
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  Counts counts;
  std::size_t at = 0;
  while ((at = text.find("\xB5"
                         "b",
                         at)) != std::string::npos &&
         at + 8 <= text.size()) {
    const std::size_t end = at + 6 + (byte(at + 4) | byte(at + 5) << 8);
    std::uint8_t a = 0, b = 0;
    for (std::size_t i = at + 2; i < end && i < text.size(); ++i) b += a += byte(i);
    if (end + 2 > text.size() || byte(end) != a || byte(end + 1) != b) {
      ++at;
      continue;
    }
    const auto known = ours.find(byte(at + 2) << 8 | byte(at + 3));
    if (known != ours.end()) ++counts[known->second];
    at = end + 2;
  }
  return counts;
}

TEST_F(Corpora, EveryGoodNmeaSentenceOfOursIsDecoded) {
  Counts all;
  for (const fs::path& file : files("gps/gpsd/daemon", ".log")) {
    const Counts expected = scan_nmea(recorded_by(file));
    EXPECT_EQ(decoded_counts("nmea0183", file), expected) << file;
    for (const auto& [type, count] : expected) all[type] += count;
  }
  for (const char* type :
       {"GGA", "RMC", "GSV", "GSA", "VTG", "ZDA", "GNS", "GLL", "GST", "VHW", "VLW"})
    EXPECT_GT(all[type], 50) << type;
}

TEST_F(Corpora, EveryGoodUbxMessageOfOursIsDecoded) {
  Counts all;
  for (const char* folder : {"gps/gpsd/daemon", "gps/pyubx2"})
    for (const fs::path& file : files(folder, ".log")) {
      const Counts expected = scan_ubx(recorded_by(file));
      EXPECT_EQ(decoded_counts("ubx", file), expected) << file;
      for (const auto& [type, count] : expected) all[type] += count;
    }
  EXPECT_GT(all["NAV-PVT"], 400);
  EXPECT_GT(all["NAV-SAT"], 300);
  EXPECT_GT(all["NAV-EOE"], 300);
  EXPECT_GT(all["NAV-DOP"], 600);
  EXPECT_GT(all["RXM-SFRBX"], 800);
  EXPECT_EQ(all["RXM-RAWX"], 14);
}

TEST_F(Corpora, AMixedPortGivesBothProtocols) {
  const fs::path file = root_ / "gps/gpsd/daemon/ublox-neo-m8l.log";
  Counts expected = scan_ubx(recorded_by(file));
  expected.merge(scan_nmea(recorded_by(file)));
  EXPECT_EQ(decoded_lines("ubx+nmea0183", file), expected);
}

}  // namespace gnss_corpora_test
}  // namespace drydock::decode
