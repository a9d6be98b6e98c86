#include "drivers/wire/dbc/protection.hpp"

#include <gtest/gtest.h>

#include <map>

#include "drivers/wire/crc.hpp"
#include "tests/drivers/wire/can_fixture.hpp"

namespace drydock::wire::dbc {
namespace protection_test {

using Columns = std::vector<std::string>;

std::vector<Columns> table(const std::string& path) {
  std::vector<Columns> rows;
  for (const std::string& line : wire::test::lines_of(wire::test::corpus(path))) {
    std::istringstream text(line);
    Columns columns;
    for (std::string column; std::getline(text, column, '\t');) columns.push_back(column);
    rows.push_back(columns);
  }
  return rows;
}

std::uint64_t hex(const std::string& text) { return std::stoull(text, nullptr, 16); }

CanFrame frame_of(const std::string& id, const std::string& data) {
  return wire::test::frame((id == "-" ? "001" : id) + "#" + data);
}

TEST(Crc, EveryCheckValueOfTheTableComesOut) {
  const auto rows = table("dbc/expected/crc_check.tsv");
  if (rows.empty()) GTEST_SKIP() << "corpora absent: dbc";
  const Columns& inputs = rows.front();
  std::size_t compared = 0;
  for (std::size_t r = 1; r < rows.size(); ++r) {
    const Columns& row = rows[r];
    const Crc crc({static_cast<unsigned>(std::stoul(row[1])), hex(row[2]), hex(row[3]),
                   row[4] == "1", hex(row[5])});
    for (std::size_t c = 6; c < row.size(); ++c) {
      std::vector<std::uint8_t> bytes;
      for (std::size_t i = 0; i < inputs[c].size(); i += 2)
        bytes.push_back(static_cast<std::uint8_t>(hex(inputs[c].substr(i, 2))));
      EXPECT_EQ(crc(bytes), hex(row[c])) << row[0] << " of " << inputs[c];
      ++compared;
    }
  }
  EXPECT_EQ(compared, 15u * 8u);
}

// The catalogue's check value: the digits 1 to 9.
TEST(Crc, TheDigitsGiveTheCheckValue) {
  const auto digits = wire::test::as_bytes("123456789");
  EXPECT_EQ(Crc({8, 0x1D, 0xFF, false, 0xFF})(digits), 0x4Bu);
  EXPECT_EQ(Crc({32, 0x04C11DB7, 0xFFFFFFFF, true, 0xFFFFFFFF})(digits), 0xCBF43926u);
}

Protection protection_of(const Columns& row, const CanFrame& frame) {
  static const std::map<std::string, Checksum> e2e{
      {"e2e_p1_both", Checksum::e2e_1_both}, {"e2e_p1_alt", Checksum::e2e_1_alternating},
      {"e2e_p1_low", Checksum::e2e_1_low},   {"e2e_p1_nibble", Checksum::e2e_1_nibble},
      {"e2e_p2", Checksum::e2e_2},           {"e2e_p5", Checksum::e2e_5}};
  Protection p;
  const std::string bare = "j1850_init0_xor";
  if (row[0].starts_with(bare)) {
    p.checksum = Checksum::crc8_j1850_bare;
    p.seed = static_cast<std::uint8_t>(hex(row[0].substr(bare.size())));
    p.at = frame.size - 1u;
    return p;
  }
  p.checksum = e2e.at(row[0]);
  if (p.checksum == Checksum::e2e_2) {
    p.data_ids[std::stoul(row[5])] = static_cast<std::uint8_t>(hex(row[6]));
  } else {
    p.data_id = static_cast<std::uint16_t>(hex(row[6]));
  }
  return p;
}

TEST(Protection, RealFramesAreIntactAndTheOneKnownBadIsNot) {
  const auto rows = table("dbc/expected/checksums.tsv");
  if (rows.empty()) GTEST_SKIP() << "corpora absent: dbc";
  std::size_t intact = 0, bad = 0;
  for (std::size_t r = 1; r < rows.size(); ++r) {
    const CanFrame frame = frame_of(rows[r][2], rows[r][3]);
    const bool good = rows[r][7] == "1";
    EXPECT_EQ(is_intact(protection_of(rows[r], frame), frame), good) << rows[r][0] << rows[r][3];
    (good ? intact : bad) += 1;
  }
  EXPECT_EQ(intact, 392u);
  EXPECT_EQ(bad, 1u);
}

TEST(Protection, WhatWeProtectIsTheRealFrame) {
  const auto rows = table("dbc/expected/checksums.tsv");
  if (rows.empty()) GTEST_SKIP() << "corpora absent: dbc";
  for (std::size_t r = 1; r < rows.size(); ++r) {
    const CanFrame real = frame_of(rows[r][2], rows[r][3]);
    const Protection p = protection_of(rows[r], real);
    CanFrame ours = real;
    ours.data[p.at] ^= 0xFF;
    ASSERT_TRUE(protect(p, ours));
    if (rows[r][7] != "1") continue;
    EXPECT_EQ(wire::test::text_of(ours), wire::test::text_of(real));
  }
}

TEST(Protection, EachFlippedBitOfAProtectedFrameIsSeen) {
  const auto vectors = {std::pair{Checksum::e2e_1_both, "CC00000000000000"},
                        std::pair{Checksum::e2e_1_nibble, "2A10000000000000"}};
  for (const auto& [checksum, data] : vectors) {
    Protection p;
    p.checksum = checksum;
    p.data_id = 0x0123;
    const CanFrame sound = wire::test::frame(std::string("001#") + data);
    EXPECT_TRUE(is_intact(p, sound));
    for (unsigned bit = 0; bit < 64; ++bit) {
      CanFrame damaged = sound;
      damaged.data[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
      EXPECT_FALSE(is_intact(p, damaged)) << bit;
    }
  }
}

// By hand: 1Ah + 25h + 30h = 6Fh; with length 4 and the identifier 2E4h: + 04h + 02h + E4h = 159h.
TEST(Protection, SumsAndXorsAreOfTheOtherBytes) {
  const CanFrame frame = wire::test::frame("2E4#1A25306F");
  Protection p;
  p.at = 3;
  p.checksum = Checksum::sum;
  EXPECT_TRUE(is_intact(p, frame));
  p.checksum = Checksum::sum_with_id;
  CanFrame with_id = frame;
  ASSERT_TRUE(protect(p, with_id));
  EXPECT_EQ(with_id.data[3], 0x59);
  p.checksum = Checksum::xor_of_bytes;
  p.seed = 0x01;
  CanFrame by_xor = frame;
  ASSERT_TRUE(protect(p, by_xor));
  EXPECT_EQ(by_xor.data[3], 0x1A ^ 0x25 ^ 0x30 ^ 0x01);
}

// AUTOSAR's example 0F AA 00 55 gives 79h; the checksum's own byte does not count.
TEST(Protection, J1850LeavesItsOwnByteOut) {
  CanFrame frame = wire::test::frame("001#0FAA790055");
  Protection p;
  p.at = 2;
  EXPECT_TRUE(is_intact(p, frame));
  frame.data[2] = 0x78;
  EXPECT_FALSE(is_intact(p, frame));
}

TEST(Protection, AFrameTooShortIsNotIntact) {
  for (const char* name : {"e2e-1-both", "e2e-2", "e2e-5", "crc8-j1850", "sum", "xor"}) {
    Protection p;
    p.checksum = *checksum_named(name);
    CanFrame empty;
    EXPECT_FALSE(is_intact(p, empty)) << name;
    EXPECT_FALSE(protect(p, empty)) << name;
    EXPECT_EQ(to_string(p.checksum), name);
  }
  EXPECT_FALSE(checksum_named("crc9"));
}

TEST(FrameCounter, TellsLostAndRepeatedFrames) {
  FrameCounter counter(15);
  using Step = FrameCounter::Step;
  EXPECT_EQ(counter.take(13), Step::first);
  EXPECT_EQ(counter.take(14), Step::next);
  EXPECT_EQ(counter.take(0), Step::next);  // wraps at its modulus
  EXPECT_EQ(counter.take(0), Step::repeated);
  EXPECT_EQ(counter.take(3), Step::lost);
  EXPECT_EQ(counter.lost(), 2u);
  EXPECT_EQ(counter.repeated(), 1u);
  counter.reset();
  EXPECT_EQ(counter.take(9), Step::first);
}

}  // namespace protection_test
}  // namespace drydock::wire::dbc
