// Compares PD0 files with a scanner that knows only checksums, and with MHKiT-Python.
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <sstream>
#include <string>

#include "tests/drivers/decode/corpora.hpp"

namespace drydock::decode {
namespace pd0_corpora_test {

using namespace corpora;

/// Counts every 7F 7F with a length and a right sum.
int scan_pd0(const std::string& text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  int count = 0;
  std::size_t at = 0;
  while ((at = text.find("\x7F\x7F", at)) != std::string::npos && at + 4 <= text.size()) {
    const std::size_t end = at + (byte(at + 2) | byte(at + 3) << 8);
    std::uint16_t sum = 0;
    for (std::size_t i = at; i < end && i < text.size(); ++i) sum += byte(i);
    const bool good =
        end > at + 6 && end + 2 <= text.size() && sum == (byte(end) | byte(end + 1) << 8);
    count += good;
    at = good ? end + 2 : at + 1;
  }
  return count;
}

TEST_F(Corpora, EveryGoodPd0EnsembleIsDecoded) {
  // The number of ensembles that MHKiT-Python finds in each complete file.
  const std::map<std::string, int> mhkit{
      {"RDI_withBT.000", 1721}, {"winriver01.PD0", 262}, {"winriver02.PD0", 75}};
  for (const auto& entry : fs::directory_iterator(root_ / "dvl/pd0/raw")) {
    if (entry.path().extension() == ".json") continue;
    const int expected = scan_pd0(read_file(entry.path()));
    EXPECT_EQ(decoded_lines("pd0", entry.path()), (Counts{{"PD0", expected}})) << entry.path();
    if (const auto known = mhkit.find(entry.path().filename()); known != mhkit.end()) {
      EXPECT_EQ(expected, known->second) << entry.path();
    }
  }
}

TEST_F(Corpora, Pd0LeadersReadAsInMhkit) {
  const auto lines = run_decode({"pd0", root_ / "dvl/pd0/raw/RDI_withBT.000", false, true}).lines();
  std::istringstream rows(read_file(root_ / "dvl/pd0/expected/RDI_withBT.jsonl"));
  std::size_t row = 0;
  for (std::string text; std::getline(rows, text); ++row) {
    const json expected = json::parse(text);
    ASSERT_LT(row, lines.size());
    EXPECT_EQ(lines[row]["ensemble"], expected["number"]);
    EXPECT_NEAR(lines[row]["heading_deg"].get<double>(), expected["heading"].get<double>(), 2e-5);
    EXPECT_NEAR(lines[row]["pitch_deg"].get<double>(), expected["pitch"].get<double>(), 2e-5);
    EXPECT_NEAR(lines[row]["roll_deg"].get<double>(), expected["roll"].get<double>(), 2e-5);
    EXPECT_EQ(lines[row]["sound_speed_mps"], expected["c_sound"]);
  }
  EXPECT_GE(row, 100u);
}

TEST_F(Corpora, Pd0BottomVelocityIsMhkitsWithTheOtherSign) {
  const auto lines = run_decode({"pd0", root_ / "dvl/pd0/raw/winriver02.PD0", false, true}).lines();
  std::istringstream rows(read_file(root_ / "dvl/pd0/expected/winriver02.jsonl"));
  std::size_t row = 0, with_lock = 0;
  for (std::string text; std::getline(rows, text); ++row) {
    ASSERT_LT(row, lines.size());
    const json theirs = json::parse(text)["vel_bt"];  // of the bed; -32.768: none
    for (std::size_t beam = 0; beam < 4; ++beam) {
      const json& velocity = lines[row]["bottom_velocity_mps"][beam];
      ASSERT_EQ(velocity.is_null(), theirs[beam].get<double>() < -32) << row;
      if (velocity.is_null()) continue;
      EXPECT_NEAR(velocity.get<double>(), -theirs[beam].get<double>(), 1e-6);
      ++with_lock;
    }
  }
  EXPECT_GT(with_lock, 100u);
}

}  // namespace pd0_corpora_test
}  // namespace drydock::decode
