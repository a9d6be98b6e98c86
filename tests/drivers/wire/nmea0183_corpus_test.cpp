#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <set>

#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "tests/drivers/wire/gpsd_logs.hpp"

namespace drydock::wire::testing {
namespace nmea0183_corpus_test {

class Nmea0183Corpus : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(corpora())) GTEST_SKIP() << "no captures at " << corpora();
  }
};

TEST_F(Nmea0183Corpus, EverySoundSentenceOfGpsdsLogsIsDecoded) {
  std::map<std::string_view, std::size_t> count;
  StreamCounters total;
  for (const auto& log : gpsd_logs()) {
    const auto reading = read_stream<Nmea0183>(gpsd_log(log));
    for (const auto& message : reading.messages) {
      ++count[std::visit([](const auto& m) { return m.type; }, message)];
    }
    total.frames += reading.counters.frames;
    total.bad_checksums += reading.counters.bad_checksums;
  }
  // These counts come from a regular expression and an XOR in another language.
  const std::map<std::string_view, std::size_t> expected{
      {"GGA", 1228}, {"RMC", 1462}, {"GSV", 4431}, {"GSA", 2000}, {"VTG", 794},
      {"ZDA", 535},  {"GNS", 112},  {"GLL", 860},  {"GST", 171},  {"HDT", 9},
      {"THS", 9},    {"HDG", 1457}, {"HDM", 7},    {"VHW", 150},  {"VLW", 150}};
  EXPECT_EQ(count, expected);
  EXPECT_EQ(total.frames, 18433u + 1852u);  // `$`, and `!` of AIS
  EXPECT_EQ(total.bad_checksums, 72u);
}

using Cell = std::pair<long, long>;  // degrees / 1e-7

/// gpsd merges the sentences of an epoch and drops the last epoch, so the test compares sets.
TEST_F(Nmea0183Corpus, PositionsAreThoseThatGpsdReports) {
  std::size_t positions = 0, reported = 0;
  for (const auto& log : gpsd_logs()) {
    const Buffer bytes = gpsd_log(log);
    if (as_text(bytes).find("\xB5\x62") != std::string_view::npos) continue;  // see the UBX test
    std::set<Cell> known;
    for (const auto& tpv : gpsd_reports(log, "TPV")) {
      if (!tpv.contains("lat") || !tpv.contains("lon")) continue;
      known.emplace(std::lround(tpv["lat"].get<double>() * 1e7),
                    std::lround(tpv["lon"].get<double>() * 1e7));
    }
    if (known.empty()) continue;
    for (const Gga& m : read_stream<Nmea0183>(bytes).all<Gga>()) {
      if (!m.latitude_rad || !m.longitude_rad) continue;
      const long latitude = std::lround(degrees(*m.latitude_rad) * 1e7);
      const long longitude = std::lround(degrees(*m.longitude_rad) * 1e7);
      ++positions;
      reported += std::ranges::any_of(known, [&](const Cell& cell) {
        return std::abs(cell.first - latitude) <= 1 && std::abs(cell.second - longitude) <= 1;
      });
    }
  }
  RecordProperty("positions", static_cast<int>(positions));
  RecordProperty("reported", static_cast<int>(reported));
  EXPECT_GT(positions, 1000u);
  EXPECT_GE(reported, positions * 95 / 100) << reported << " of " << positions;
}

/// Columns: checksum (ok or BAD), kind, source, sentence, note.
TEST_F(Nmea0183Corpus, SpeedLogSentencesAreReadAndWrongChecksumsRefused) {
  std::ifstream table{corpora() / "eml/speed_log_sentences.tsv"};
  std::string line;
  std::getline(table, line);
  std::size_t sound = 0, bad = 0;
  while (std::getline(table, line)) {
    const std::size_t start = line.find('$');
    const std::string text = line.substr(start, line.find('\t', start) - start);
    const auto reading = read_stream<Nmea0183>(as_bytes(text + "\r\n"));
    const bool is_sound = line.starts_with("ok");
    (is_sound ? sound : bad) += 1;
    EXPECT_EQ(reading.frames.size(), is_sound ? 1u : 0u) << text;
    EXPECT_EQ(reading.counters.bad_checksums, is_sound ? 0u : 1u) << text;
    const std::string_view formatter = std::string_view{text}.substr(3, 3);
    const bool ours = formatter == "VHW" || formatter == "VBW" || formatter == "VLW";
    EXPECT_EQ(reading.messages.size(), is_sound && ours ? 1u : 0u) << text;
  }
  EXPECT_EQ(sound, 23u);
  EXPECT_EQ(bad, 2u);
}

TEST_F(Nmea0183Corpus, ARealSpeedLogAgreesWithItself) {
  // Its knots and km/h are both rounded to 0.1, so they must agree within half a digit.
  const auto log = gpsd_log(gpsd_folder() / "bundg_zeus_9.log");
  const auto speeds = read_stream<Nmea0183>(log).all<Vhw>();
  ASSERT_EQ(speeds.size(), 150u);
  EXPECT_NEAR(*speeds.front().speed_mps, 6.6 * 1852 / 3600, 1e-12);
  EXPECT_NEAR(*speeds.front().speed_mps, 12.3 / 3.6, 0.05 * 1852 / 3600 + 0.05 / 3.6);
}

}  // namespace nmea0183_corpus_test
}  // namespace drydock::wire::testing
