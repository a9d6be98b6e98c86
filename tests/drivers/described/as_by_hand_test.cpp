#include <fstream>

#include "drivers/wire/dvl/nortek.hpp"
#include "drivers/wire/dvl/water_linked.hpp"
#include "tests/drivers/described/decoded.hpp"

/// Real sentences read as with the codecs written by hand.
namespace drydock::described::test {
namespace as_by_hand_test {

using namespace wire::testing;
using wire::described::Record;

/// Lines of a corpus file that begin with a word, without their notes.
std::vector<std::string> corpus_lines(const std::string& file, std::string_view word, char mark) {
  std::vector<std::string> lines;
  std::ifstream in(corpora() / file);
  for (std::string line; std::getline(in, line);) {
    const auto at = line.find(mark == '$' ? "$" : "\twr");
    if (!line.starts_with(word) || at == line.npos) continue;
    std::string sentence = line.substr(mark == '$' ? at : at + 1);
    lines.push_back(sentence.substr(0, sentence.rfind('*') + 3) + "\r\n");
  }
  return lines;
}

std::optional<double> in_seconds(const std::optional<std::chrono::microseconds>& t) {
  return t ? std::optional(std::chrono::duration<double>(*t).count()) : std::nullopt;
}

void expect_same(const Record& record, std::string_view key,
                 const std::optional<double>& expected) {
  const double value = value_of(record, key);
  EXPECT_EQ(!std::isnan(value), expected.has_value()) << key;
  if (expected) {
    EXPECT_DOUBLE_EQ(value, *expected) << key;
  }
}

TEST(DescribedValues, WaterLinkedsSentencesReadAsWithTheCodecWrittenByHand) {
  if (!std::filesystem::exists(corpora())) GTEST_SKIP() << "no corpora";
  const auto wrz = shipped("water-linked-wrz.toml");
  std::size_t compared = 0;
  for (const auto& line : corpus_lines("dvl/waterlinked/wl_serial_vectors.txt", "crc_ok", 'w')) {
    const auto by_hand = wire::WaterLinked::decode(as_bytes(line));
    ASSERT_TRUE(by_hand);
    if (const auto* m = std::get_if<wire::water_linked::BottomVelocity>(&*by_hand)) {
      const Record record = decoded(wrz, line);
      expect_same(record, "forward_mps", m->velocity_mps[0]);
      expect_same(record, "starboard_mps", m->velocity_mps[1]);
      expect_same(record, "down_mps", m->velocity_mps[2]);
      expect_same(record, "altitude_m", m->altitude_m);
      expect_same(record, "figure_of_merit_mps", m->figure_of_merit_mps);
      expect_same(record, "covariance_xx_m2ps2", m->covariance[0]);
      expect_same(record, "covariance_xz_m2ps2", m->covariance[2]);
      expect_same(record, "covariance_zz_m2ps2", m->covariance[8]);
      expect_same(record, "valid_at_s", in_seconds(m->validity));
      expect_same(record, "sent_at_s", in_seconds(m->transmission));
      expect_same(record, "interval_s", m->interval_s);
      EXPECT_EQ(record.valid, m->valid);
      ++compared;
    }
    if (const auto* m = std::get_if<wire::water_linked::Transducer>(&*by_hand)) {
      const Record record = decoded(wrz, line);
      expect_same(record, "velocity_mps", m->velocity_mps);
      expect_same(record, "distance_m", m->distance_m);
      expect_same(record, "rssi_dbm", m->rssi_dbm);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 6u) << "one wrz and five wru have a right checksum";
}

TEST(DescribedValues, NorteksSentencesReadAsWithTheCodecWrittenByHand) {
  if (!std::filesystem::exists(corpora())) GTEST_SKIP() << "no corpora";
  const auto nortek = shipped("nortek-bt.toml");
  std::size_t compared = 0;
  for (const auto& line : corpus_lines("dvl/nortek/pnor_sentences.txt", "ok $PNORBT", '$')) {
    const auto by_hand = wire::Nortek::decode(as_bytes(line));
    const auto* m = by_hand ? std::get_if<wire::NortekVelocity>(&*by_hand) : nullptr;
    if (!m) continue;
    const Record record = decoded(nortek, line);
    expect_same(record, "time_s", m->ping_time_s);
    expect_same(record, "age_s", -*m->after_sentence_s);
    expect_same(record, "forward_mps", m->velocity_mps[0]);
    expect_same(record, "down_mps", m->velocity_mps[2]);
    expect_same(record, "figure_of_merit_mps", m->figure_of_merit_mps);
    expect_same(record, "range_1_m", m->distance_m[0]);
    expect_same(record, "range_4_m", m->distance_m[3]);
    if (record.type == "PNORBT9") expect_same(record, "sound_speed_mps", m->sound_speed_mps);
    ++compared;
  }
  EXPECT_EQ(compared, 2u);
}

}  // namespace as_by_hand_test
}  // namespace drydock::described::test
