#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "drivers/wire/dvl/pd0.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

/// Files of real instruments, and the values that the MHKiT library (float32) reads in them.
namespace drydock::wire::testing {
namespace pd0_corpus_test {

constexpr double float32_relative = 1.2e-7;

struct Capture {
  std::string file, expected;
  std::size_t ensembles, with_bottom_track;
  double heading_offset_deg = 0;  ///< declination from the set-up, which MHKiT added
};

void PrintTo(const Capture& capture, std::ostream* out) { *out << capture.file; }

class Pd0Corpus : public ::testing::TestWithParam<Capture> {
 protected:
  void SetUp() override {
    const auto folder = corpora() / "dvl/pd0";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no captures at " << corpora();
    reading_ = read_stream<Pd0>(read_file(folder / "raw" / GetParam().file));
    const Buffer text = read_file(folder / "expected" / GetParam().expected);
    std::istringstream lines{std::string{text.begin(), text.end()}};
    for (std::string line; std::getline(lines, line);) {
      rows_.push_back(nlohmann::json::parse(line));
    }
  }

  Reading<Pd0> reading_;
  std::vector<nlohmann::json> rows_;
};

void expect_float(const std::optional<double>& value, double expected, const char* what) {
  ASSERT_TRUE(value) << what;
  EXPECT_NEAR(*value, expected, std::abs(expected) * float32_relative + 1e-6) << what;
}

/// MHKiT keeps the velocity of the bed and the marks of bad beams as they are on the wire.
void expect_bottom_track(const Pd0BottomTrack& m, const nlohmann::json& row) {
  for (std::size_t i = 0; i < 4; ++i) {
    const double velocity = row["vel_bt"][i], range = row["dist_bt"][i];
    const bool bad = velocity < -32.767;
    EXPECT_EQ(!m.velocity_mps[i].has_value(), bad);
    if (!bad) expect_float(m.velocity_mps[i], -velocity, "velocity");
    EXPECT_EQ(!m.range_m[i].has_value(), range == 0);
    if (range != 0) expect_float(m.range_m[i], range, "range");
    EXPECT_EQ(m.correlation[i], row["corr_bt"][i]);
    EXPECT_EQ(m.percent_good[i], row["prcnt_gd_bt"][i]);
  }
}

TEST_P(Pd0Corpus, EverySoundEnsembleIsDecoded) {
  EXPECT_EQ(reading_.frames.size(), GetParam().ensembles);
  EXPECT_EQ(reading_.messages.size(), GetParam().ensembles);
  std::size_t with_bottom_track = 0;
  for (const Pd0Ensemble& e : reading_.all<Pd0Ensemble>()) with_bottom_track += !!e.bottom_track;
  EXPECT_EQ(with_bottom_track, GetParam().with_bottom_track);
  EXPECT_EQ(reading_.counters.bad_checksums, 0u);
}

TEST_P(Pd0Corpus, ReadsWhatAnotherLibraryReads) {
  const auto ensembles = reading_.all<Pd0Ensemble>();
  ASSERT_FALSE(rows_.empty());
  ASSERT_LE(rows_.size(), ensembles.size());
  for (const auto& row : rows_) {
    SCOPED_TRACE(row["i"].get<int>());
    const Pd0Ensemble& e = ensembles[row["i"].get<std::size_t>()];
    expect_float(degrees(e.variable.heading_rad).value() + GetParam().heading_offset_deg,
                 row["heading"], "heading");
    expect_float(degrees(e.variable.pitch_rad), row["pitch"], "pitch");
    expect_float(degrees(e.variable.roll_rad), row["roll"], "roll");
    expect_float(e.variable.temperature_k.value() - 273.15, row["temp"], "temperature");
    expect_float(e.variable.sound_speed_mps, row["c_sound"], "sound speed");
    EXPECT_EQ(e.variable.ensemble, row["number"].get<unsigned>());
    EXPECT_NEAR(seconds(e.variable.clock.value().time_since_epoch()), row["time"], 1e-3);
    if (row.contains("vel_bt")) {
      ASSERT_TRUE(e.bottom_track);
      expect_bottom_track(*e.bottom_track, row);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Captures, Pd0Corpus,
    ::testing::Values(Capture{"RDI_withBT.000", "RDI_withBT.jsonl", 1721, 1721},
                      Capture{"RDI_7f79.000", "RDI_7f79.jsonl", 60, 0},
                      Capture{"winriver01.PD0", "winriver01.jsonl", 262, 262, 8.28},
                      Capture{"winriver02.PD0", "winriver02.jsonl", 75, 75}),
    [](const auto& test) { return test.param.expected.substr(0, test.param.expected.find('.')); });

}  // namespace pd0_corpus_test
}  // namespace drydock::wire::testing
