#include "drivers/wire/dvl/pd0_vmdas.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <fstream>

#include "drivers/wire/dvl/pd0.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

/// Navigation in data type 0x2000: a block made by hand after the VmDas guide's table, and a REMUS
/// vehicle's dive.
namespace drydock::wire::testing {
namespace pd0_vmdas_test {

using std::chrono::year_month_day;
constexpr double degree = units::degree;
constexpr std::uint16_t every_flag = 0x7FF;

template <class T>
void put(Buffer& block, std::size_t at, T value) {
  std::memcpy(block.data() + at, &value, sizeof value);
}

/// 45 degrees are an eighth of a turn: 2^29 of 32 bits, 2^13 of 16.
Buffer vmdas(std::uint16_t flags = every_flag) {
  Buffer block(78);
  put<std::uint16_t>(block, 0, 0x2000);
  block[2] = 29;
  block[3] = 2;
  put<std::uint16_t>(block, 4, 2008);
  put<std::uint32_t>(block, 6, 43'200'0000);   // noon, in 0.1 ms
  put<std::int32_t>(block, 10, -1500);         // ms
  put<std::int32_t>(block, 14, 1 << 29);       // 45 N
  put<std::int32_t>(block, 18, -(1 << 30));    // 90 W
  put<std::uint32_t>(block, 22, 43'201'2500);  // 1.25 s later
  put<std::int32_t>(block, 26, -(1 << 28));    // 22.5 S
  put<std::int32_t>(block, 30, 1 << 29);       // 45 E
  put<std::uint16_t>(block, 34, 5144);         // mm/s
  put<std::uint16_t>(block, 36, 3u << 14);     // 270
  put<std::uint16_t>(block, 38, 1u << 13);     // 45
  put<std::uint16_t>(block, 40, 5000);
  put<std::uint16_t>(block, 42, 1u << 15);  // 180
  put<std::uint16_t>(block, 46, flags);
  put<std::int16_t>(block, 62, -(1 << 10));  // -5.625
  put<std::int16_t>(block, 64, 1 << 9);      // 2.8125
  put<std::uint16_t>(block, 66, 7u << 13);   // 315
  return block;
}

std::optional<VmdasNavigation> read_vmdas(const Buffer& block) {
  Pd0ComputerNavigation m;
  return read_block(block, m) ? m.vmdas : std::nullopt;
}

TEST(Vmdas, EveryFieldStandsWhereTheGuideSays) {
  const auto m = read_vmdas(vmdas());
  ASSERT_TRUE(m);
  EXPECT_EQ(m->date,
            year_month_day(std::chrono::year{2008}, std::chrono::month{2}, std::chrono::day{29}));
  EXPECT_EQ(seconds(m->first.time_of_day), 43200.0);
  EXPECT_DOUBLE_EQ(m->first.latitude_rad.value(), 45 * degree);
  EXPECT_DOUBLE_EQ(m->first.longitude_rad.value(), -90 * degree);
  EXPECT_EQ(seconds(m->last.time_of_day), 43201.25);
  EXPECT_DOUBLE_EQ(m->last.latitude_rad.value(), -22.5 * degree);
  EXPECT_DOUBLE_EQ(m->last.longitude_rad.value(), 45 * degree);
  EXPECT_EQ(m->clock_offset_s, -1.5);
  EXPECT_EQ(m->speed_mps, 5.144);
  EXPECT_DOUBLE_EQ(m->course_true_rad.value(), 270 * degree);
  EXPECT_DOUBLE_EQ(m->course_magnetic_rad.value(), 45 * degree);
  EXPECT_EQ(m->speed_made_good_mps, 5.0);
  EXPECT_DOUBLE_EQ(m->course_made_good_rad.value(), 180 * degree);
  EXPECT_DOUBLE_EQ(m->pitch_rad.value(), -5.625 * degree);
  EXPECT_DOUBLE_EQ(m->roll_rad.value(), 2.8125 * degree);
  EXPECT_DOUBLE_EQ(m->heading_rad.value(), 315 * degree);
}

TEST(Vmdas, WhatItsFlagsDoNotCallValidIsEmpty) {
  const auto none = read_vmdas(vmdas(0));
  ASSERT_TRUE(none);
  EXPECT_FALSE(none->date || none->first.latitude_rad || none->last.longitude_rad ||
               none->last.time_of_day || none->speed_mps || none->course_true_rad ||
               none->heading_rad || none->pitch_rad || none->clock_offset_s);
  const auto position = read_vmdas(vmdas(1u << 1));
  EXPECT_TRUE(position->first.latitude_rad && position->last.longitude_rad);
  EXPECT_FALSE(position->speed_mps || position->heading_rad || position->date);
}

TEST(Vmdas, ABlockCutShortOrWithoutADateIsLeftToBeCounted) {
  const Buffer whole = vmdas();
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_FALSE(read_vmdas(Buffer(whole.begin(), whole.begin() + static_cast<int>(size))));
  Buffer no_date = whole;
  no_date[3] = 13;
  EXPECT_FALSE(read_vmdas(no_date));
}

RC_GTEST_PROP(Vmdas, AnyBytesAreReadWithoutHarm, (Buffer rest)) {
  rest.insert(rest.begin(), {0x00, 0x20});
  Pd0ComputerNavigation m;
  const bool read = read_block(rest, m);
  RC_ASSERT(read == (m.vmdas || m.remus));
  if (m.vmdas) RC_ASSERT(std::abs(m.vmdas->last.latitude_rad.value_or(0)) <= 90 * degree);
  if (m.remus) RC_ASSERT(std::abs(m.remus->latitude_rad) <= 90 * degree);
}

/// nav.csv beside the dive: a row for each ensemble from 14 on, by its number.
TEST(Remus, ItsOwnNavigationIsThatOfTheTableBesideTheDive) {
  const auto file = corpora() / "dvl/pd0/raw/remus_20141219_a.adc";
  std::ifstream table(corpora() / "dives/remus_20141219_a/nav.csv");
  if (!table) GTEST_SKIP() << "no captures at " << corpora();
  std::map<std::uint32_t, RemusNavigation> read;
  for (const auto& message : read_stream<Pd0>(read_file(file)).messages) {
    const auto& m = std::get<Pd0Ensemble>(message);
    ASSERT_TRUE(m.computer.remus);
    read[m.variable.ensemble] = *m.computer.remus;
  }
  std::string line;
  std::getline(table, line);
  std::size_t rows = 0;
  for (; std::getline(table, line); ++rows) {
    double time_s = 0, latitude_deg = 0, longitude_deg = 0, speed_mps = 0, heading_deg = 0;
    unsigned ensemble = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%u,%lf,%lf,%lf,%lf", &time_s, &ensemble, &latitude_deg,
                          &longitude_deg, &speed_mps, &heading_deg),
              6);
    const RemusNavigation& m = read.at(ensemble);
    EXPECT_EQ(m.date, year_month_day(std::chrono::year{2014}, std::chrono::month{12},
                                     std::chrono::day{19}));
    EXPECT_NEAR(m.latitude_rad, latitude_deg * degree, 1e-8 * degree);
    EXPECT_NEAR(m.longitude_rad, longitude_deg * degree, 1e-8 * degree);
    EXPECT_NEAR(m.speed_mps, speed_mps, 1e-9);
    EXPECT_NEAR(m.heading_rad, heading_deg * degree, 1e-4 * degree);
  }
  EXPECT_EQ(rows, 1934U);
}

}  // namespace pd0_vmdas_test
}  // namespace drydock::wire::testing
