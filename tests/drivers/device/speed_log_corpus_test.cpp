#include <sstream>

#include "tests/drivers/device/support.hpp"

/// Feeds sentences of real speed logs and of other programs' tests through the whole driver. The
/// expected values come from their text: the test counts the fields again, with knots of 1852 m in
/// 3600 s.
namespace drydock::device::test {
namespace speed_log_corpus_test {

using measurement::WaterSpeed;

struct Row {
  bool sound = false;
  std::string sentence;
  std::vector<std::string> fields;  ///< fields of the sentence after its address
  std::string formatter() const { return sentence.substr(3, 3); }
};

/// Columns: checksum (ok or BAD), kind, source, sentence, note.
std::vector<Row> rows_of(const std::filesystem::path& table) {
  std::vector<Row> rows;
  std::ifstream file(table);
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    Row row;
    row.sound = line.starts_with("ok\t");
    const std::size_t start = line.find('$');
    row.sentence = line.substr(start, line.find('\t', start) - start);
    std::istringstream body(row.sentence.substr(7, row.sentence.rfind('*') - 7));
    for (std::string field; std::getline(body, field, ',');) row.fields.push_back(field);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::optional<double> number(const Row& row, std::size_t field, double unit) {
  if (field >= row.fields.size() || row.fields[field].empty()) return {};
  return std::stod(row.fields[field]) * unit;
}

/// VHW: knots in the fifth field. VBW: along and across in the first two, if A follows. VLW: total
/// distance through the water in the first.
WaterSpeed expected_of(const Row& row) {
  WaterSpeed expected;
  if (row.formatter() == "VHW") expected.longitudinal_mps = number(row, 4, knot);
  if (row.formatter() == "VBW" && row.fields.at(2) == "A") {
    expected.longitudinal_mps = number(row, 0, knot);
    expected.transverse_mps = number(row, 1, knot);
  }
  if (row.formatter() == "VLW") expected.distance_m = number(row, 0, 1852);
  return expected;
}

void expect_same(const std::optional<double>& found, const std::optional<double>& expected) {
  ASSERT_EQ(found.has_value(), expected.has_value());
  if (found) {
    EXPECT_NEAR(*found, *expected, 1e-9);
  }
}

class SpeedLogCorpus : public testing::Test {
 protected:
  void SetUp() override {
    const auto table = corpora() / "eml/speed_log_sentences.tsv";
    if (!exists(table)) GTEST_SKIP() << "no sentences in " << table;
    rows = rows_of(table);
    ASSERT_FALSE(rows.empty());
  }
  static std::vector<WaterSpeed> heard(const std::string& sentence) {
    Ear ear;
    byte_driver(options(Kind::emlog, "nmea0183"))->receive(octets(sentence + "\r\n"), at_s(1), ear);
    return ear.all<WaterSpeed>();
  }
  std::vector<Row> rows;
};

TEST_F(SpeedLogCorpus, EverySoundSentenceGivesWhatItsFieldsSayOfTheWater) {
  std::size_t speeds = 0, distances = 0;
  for (const Row& row : rows) {
    SCOPED_TRACE(row.sentence);
    const auto found = heard(row.sentence);
    const bool speed = row.formatter() == "VHW" || row.formatter() == "VBW";
    const bool distance = row.formatter() == "VLW" && !row.fields.at(0).empty();
    ASSERT_EQ(found.size(), row.sound && (speed || distance) ? 1U : 0U);
    if (found.empty()) continue;
    (speed ? speeds : distances) += 1;
    const WaterSpeed expected = expected_of(row);
    expect_same(found[0].longitudinal_mps, expected.longitudinal_mps);
    expect_same(found[0].transverse_mps, expected.transverse_mps);
    expect_same(found[0].distance_m, expected.distance_m);
  }
  EXPECT_GE(speeds, 14U);
  EXPECT_GE(distances, 4U);
}

TEST_F(SpeedLogCorpus, AnyTalkerMaySpeakAndADamagedSentenceIsRefused) {
  for (const Row& row : rows) {
    if (!row.sound) continue;
    const auto own = heard(row.sentence);
    for (const std::string talker : {"VM", "VD", "VW", "II", "SD", "HC", "ZZ"}) {
      const std::string body = talker + row.sentence.substr(3, row.sentence.rfind('*') - 3);
      const Octets said = nmea(body);
      const auto found = heard({said.begin(), said.end() - 2});
      ASSERT_EQ(found.size(), own.size()) << body;
      if (own.empty()) continue;
      EXPECT_EQ(found[0].longitudinal_mps, own[0].longitudinal_mps);
      EXPECT_EQ(found[0].distance_m, own[0].distance_m);
      std::string damaged(said.begin(), said.end() - 2);
      damaged[7] ^= 1;
      EXPECT_TRUE(heard(damaged).empty()) << damaged;
    }
  }
}

}  // namespace speed_log_corpus_test
}  // namespace drydock::device::test
