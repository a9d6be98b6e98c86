#include "hil/sky/rinex.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <unistd.h>

#include <cmath>

#include "hil/sky/broadcast_orbits.hpp"
#include "hil/sky/ephemeris_file.hpp"
#include "hil/sky/orbit.hpp"
#include "tests/hil/sky/files.hpp"

namespace drydock::sky {
namespace rinex_test {

using namespace std::chrono;
using testing::HasSubstr;

/// Reads a text that must be valid.
Navigation read(const std::string& text) { return read_navigation(text).value(); }

std::string error_of(const std::string& text) {
  const auto file = read_navigation(text);
  return file ? "no error" : std::to_string(file.error().line) + ": " + file.error().what;
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

const std::string version_3 = test::text_of(test::walker());
const std::string version_2 = test::text_of(test::walker("26n"));

TEST(Rinex, OfAMixedFileTheGpsRecordsAreRead) {
  const Navigation file = read(version_3);
  EXPECT_DOUBLE_EQ(file.version, 3.04);
  EXPECT_EQ(file.leap_seconds, 18);
  ASSERT_EQ(file.records.size(), 26);
  EXPECT_EQ(file.passed_over, 2);
  const Ephemeris& third = file.records[2];
  EXPECT_EQ(third.prn, 3);
  EXPECT_EQ(third.line, 20);
  EXPECT_EQ(third.toe, test::walker_toe);
  EXPECT_EQ(third.toc, test::walker_toe);
  EXPECT_DOUBLE_EQ(third.af0_s, 3e-6);
  EXPECT_NEAR(third.sqrt_a * third.sqrt_a, 26'559'710, 1e-3);
  EXPECT_NEAR(third.m0_rad, M_PI, 1e-12);
  EXPECT_NEAR(third.i0_rad, 55 * M_PI / 180, 1e-12);
  EXPECT_TRUE(third.healthy());
  EXPECT_EQ(file.records[24].health, 63U);
}

TEST(Rinex, VersionTwoSaysTheSameWithFortransExponents) {
  const Navigation old = read(version_2), now = read(version_3);
  ASSERT_EQ(old.records.size(), 2);
  for (const Ephemeris& record : old.records) {
    const Ephemeris& same = now.records.at(record.prn - 1U);
    EXPECT_EQ(record.prn, same.prn);
    EXPECT_EQ(record.toe, same.toe);
    EXPECT_EQ(satellite_at(record, record.toe).ecef_m, satellite_at(same, same.toe).ecef_m);
    EXPECT_EQ(record.af0_s, same.af0_s);
  }
}

TEST(Rinex, AnExponentOfThreeDigitsHasNoLetter) {
  // Fortran writes it so, and broadcast files of 2012 contain it.
  const auto text = changed(version_2, "0.000000000000D+00\n    3", "0.499063314480-269\n    3");
  EXPECT_DOUBLE_EQ(read(text).records.at(0).af2_ps, 0.499063314480e-269);
}

TEST(Rinex, LinesMayEndWithCarriageReturns) {
  std::string dos;
  for (const char c : version_2) dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(read(dos).records.size(), 2);
}

TEST(Rinex, ToeIsTheSecondOfTheWeekNearestToTheClocksTime) {
  // A clock time just before midnight on Saturday, and an orbit time in the following week.
  auto text = changed(version_2, " 3 26 11 21 10  0  0.0", " 3 26 11 21 23 59 44.0");
  text = changed(text, "5.544000000000D+05", "0.000000000000D+00");
  const Ephemeris record = read(text).records.at(0);
  EXPECT_EQ(record.toe - record.toc, 16s);
  EXPECT_EQ(record.toe, gps_time(sys_days{2026y / November / 22}, 0s));
}

TEST(Rinex, WhatIsLongerThanAnyNavigationFileIsRefusedBeforeItIsRead) {
  EXPECT_EQ(error_of(version_3 + std::string(most_navigation_bytes, '\n')),
            "1: longer than 64 MB, which no navigation file is");
}

TEST(Rinex, MoreRecordsThanAnyFileHasAreRefused) {
  const auto body = version_2.find("END OF HEADER");
  const auto first = version_2.find('\n', body) + 1;
  const std::string records = version_2.substr(first);
  std::string text = version_2.substr(0, first);
  for (std::size_t n = 0; n < most_navigation_records; n += 2) text += records;
  EXPECT_EQ(read(text).records.size(), most_navigation_records);
  EXPECT_THAT(error_of(text + records), HasSubstr(": more than 20000 GPS records"));
}

TEST(Rinex, AFileThatIsTooLongOrNeverEndsIsRefused) {
  const auto endless = read_navigation_file("/dev/zero");
  ASSERT_FALSE(endless);
  EXPECT_THAT(endless.error().message, HasSubstr("a device or a pipe, not a file"));

  const auto sparse =
      std::filesystem::temp_directory_path() / ("drydock-zeros-" + std::to_string(::getpid()));
  std::ofstream(sparse) << "";
  std::filesystem::resize_file(sparse, 65'000'000);
  const auto longer = read_navigation_file(sparse);
  std::filesystem::remove(sparse);
  ASSERT_FALSE(longer);
  EXPECT_THAT(longer.error().message, HasSubstr("longer than 64 MB, which no navigation file is"));
}

TEST(Rinex, AMistakeIsToldWithItsLine) {
  EXPECT_EQ(error_of(""), "1: no RINEX file: RINEX VERSION / TYPE is expected in columns 61 to 80");
  EXPECT_EQ(error_of(changed(version_3, "3.04", "4.00")),
            "1: version '4.00' is not read, allowed: 2 and 3");
  EXPECT_THAT(error_of(changed(version_2, "N: GPS NAV DATA", "OBSERVATION DAT")),
              HasSubstr("1: file type 'O', allowed: N"));
  EXPECT_EQ(error_of(version_3.substr(0, 150)), "2: the file ends before END OF HEADER");
  EXPECT_EQ(error_of(changed(version_3, "9.599310885969E-01", "9.599310885969F-01")),
            "8: '9.599310885969F-01' in columns 5 to 23: expected a number");
  EXPECT_EQ(error_of(changed(version_3, "9.599310885969E-01", "                  ")),
            "8: '' in columns 5 to 23: expected a number");
  EXPECT_EQ(error_of(changed(version_3, "9.599310885969E-01", "9.5993108859E+999")),
            "8: '9.5993108859E+999' in columns 5 to 23: expected a number");
  EXPECT_EQ(error_of(changed(version_2, "\n 3 26 11", "\n33 26 11")),
            "4: satellite '33', allowed: 1 to 32");
  EXPECT_THAT(error_of(changed(version_2, "26 11 21 10", "26 13 21 10")),
              HasSubstr("4: the time of the clock is none"));
  EXPECT_EQ(error_of(changed(version_2, "5.544000000000D+05", "6.048000000000D+05")),
            "11: G03 of line 4: toe is 604800 s of the week, allowed: 0 to 604800");
  EXPECT_EQ(error_of(version_2.substr(0, version_2.size() - 23)),
            "18: the file ends within the record of G11 that begins in line 12");
  EXPECT_EQ(error_of(changed(version_3, "\nG02 ", "\n    ")), "12: expected a satellite, as G05");
}

/// Properties of all records of a file: they can be selected and evaluated.
void use(const Navigation& file) {
  const BroadcastOrbits orbits(file.records);
  for (int prn = 1; prn <= highest_prn; ++prn) {
    const Ephemeris* record = orbits.nearest(prn, test::walker_toe, BroadcastOrbits::Health::any);
    if (record == nullptr) continue;
    RC_ASSERT(std::isfinite(satellite_at(*record, test::walker_toe).ecef_m.norm()));
  }
}

RC_GTEST_PROP(DamagedRinex, CutAnywhereItGivesRecordsOrAnErrorWithALineOfTheFile, (bool old)) {
  const std::string& whole = old ? version_2 : version_3;
  const auto text = whole.substr(0, *rc::gen::inRange<std::size_t>(0, whole.size() + 1));
  const auto file = read_navigation(text);
  if (file) return use(*file);
  RC_ASSERT(file.error().line >= 1);
  RC_ASSERT(file.error().line <= 1 + std::ranges::count(text, '\n'));
}

RC_GTEST_PROP(DamagedRinex, WithOtherBytesItGivesRecordsOrAnErrorNeverACrash, (bool old)) {
  std::string text = old ? version_2 : version_3;
  const auto damage = *rc::gen::container<std::vector<std::pair<std::size_t, char>>>(
      rc::gen::pair(rc::gen::inRange<std::size_t>(0, text.size()),
                    rc::gen::oneOf(rc::gen::arbitrary<char>(),
                                   rc::gen::elementOf(std::string("0123456789+-.DEGRN \n")))));
  for (const auto& [at, byte] : damage) text[at] = byte;
  if (const auto file = read_navigation(text)) use(*file);
}

}  // namespace rinex_test
}  // namespace drydock::sky
