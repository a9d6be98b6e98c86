#include "drivers/wire/dvl/pd0_winriver.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "drivers/wire/dvl/pd0.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

/// Sentences of a receiver in ensembles: made blocks, and captures that have the same sentence as
/// numbers and as text.
namespace drydock::wire::testing {
namespace pd0_winriver_test {

constexpr double degree = units::degree, knot = 1852.0 / 3600.0;

/// Little-endian numbers and characters, one behind the other.
struct Block {
  Buffer bytes;
  template <class T>
  Block& put(T value) {
    const auto* raw = reinterpret_cast<const std::uint8_t*>(&value);
    bytes.insert(bytes.end(), raw, raw + sizeof value);
    return *this;
  }
  Block& text(std::string_view text, std::size_t size) {
    bytes.insert(bytes.end(), text.begin(), text.end());
    bytes.resize(bytes.size() + size - text.size());
    return *this;
  }
};

Block binary(std::uint16_t kind, std::uint16_t size, double delta_s) {
  return Block{}.put(std::uint16_t{0x2022}).put(kind).put(size).put(delta_s);
}

Buffer gga(double latitude_deg, char north, std::uint8_t quality = 2, std::uint16_t kind = 104) {
  return binary(kind, 57, -0.125)
      .text("$GPGGA", 7)
      .text("235959.75", 10)
      .put(latitude_deg)
      .put(north)
      .put(149.0625)
      .put('W')
      .put(quality)
      .put(std::uint8_t{9})
      .put(0.75F)
      .put(108.5F)
      .put('M')
      .put(-28.25F)
      .put('M')
      .put(5.5F)
      .put(std::uint16_t{135})
      .bytes;
}

Buffer vtg(char mode, std::uint16_t kind = 105) {
  return binary(kind, 28, 0.25)
      .text("$INVTG", 7)
      .put(94.5F)
      .put('T')
      .put(73.75F)
      .put('M')
      .put(4.0F)
      .put('N')
      .put(7.408F)
      .put('K')
      .put(mode)
      .bytes;
}

Buffer as_text_block(std::uint16_t id, std::string_view sentence) {
  Block block;
  block.put(id).put(static_cast<std::uint16_t>(sentence.size())).text(sentence, sentence.size());
  return block.put(std::uint16_t{0xF0D9}).bytes;  // what stands behind it in captures
}

WinRiverSentences read(const Buffer& block) {
  WinRiverSentences m;
  EXPECT_TRUE(read_block(block, m));
  return m;
}

void refused(const Buffer& block) {
  WinRiverSentences m;
  EXPECT_FALSE(read_block(block, m));
  EXPECT_TRUE(m.gga.empty() && m.vtg.empty());
}

TEST(WinRiver, APositionInNumbersStandsWhereItsReaderFindsIt) {
  for (const std::uint16_t kind : {4, 104}) {
    const auto m = read(gga(64.5, 'N', 2, kind));
    ASSERT_EQ(m.gga.size(), 1U);
    EXPECT_EQ(m.gga[0].delta_s, -0.125);
    const Gga& s = m.gga[0].sentence;
    EXPECT_EQ(s.talker.text(), "GP");
    EXPECT_EQ(seconds(s.time_of_day), 86399.75);
    EXPECT_DOUBLE_EQ(s.latitude_rad.value(), 64.5 * degree);
    EXPECT_DOUBLE_EQ(s.longitude_rad.value(), -149.0625 * degree);
    EXPECT_EQ(s.quality, 2);
    EXPECT_EQ(s.satellites_used, 9);
    EXPECT_EQ(s.horizontal_dop, 0.75);
    EXPECT_EQ(s.mean_sea_level_height_m, 108.5);
    EXPECT_EQ(s.geoid_separation_m, -28.25);
    EXPECT_EQ(s.differential_age_s, 5.5);
    EXPECT_EQ(s.differential_station, 135);
  }
  EXPECT_DOUBLE_EQ(read(gga(33.5, 'S')).gga[0].sentence.latitude_rad.value(), -33.5 * degree);
}

TEST(WinRiver, ACourseInNumbersStandsWhereItsReaderFindsIt) {
  for (const std::uint16_t kind : {5, 105}) {
    const auto m = read(vtg('D', kind));
    ASSERT_EQ(m.vtg.size(), 1U);
    EXPECT_EQ(m.vtg[0].delta_s, 0.25);
    const Vtg& s = m.vtg[0].sentence;
    EXPECT_EQ(s.talker.text(), "IN");
    EXPECT_DOUBLE_EQ(s.course_true_rad.value(), 94.5 * degree);
    EXPECT_DOUBLE_EQ(s.course_magnetic_rad.value(), 73.75 * degree);
    EXPECT_DOUBLE_EQ(s.speed_mps.value(), 4 * knot);
    EXPECT_EQ(s.mode.value, 'D');
  }
}

TEST(WinRiver, ASentenceAsTextNeedsNoChecksum) {
  const auto m = read(as_text_block(
      0x2101, "$GPGGA,120000.50,3330.000000,S,15115.000000,E,1,8,1.5,20.5,M,30.5,M,,\r\n"));
  ASSERT_EQ(m.gga.size(), 1U);
  EXPECT_FALSE(m.gga[0].delta_s);
  EXPECT_EQ(seconds(m.gga[0].sentence.time_of_day), 43200.5);
  EXPECT_DOUBLE_EQ(m.gga[0].sentence.latitude_rad.value(), -33.5 * degree);
  const auto course = read(as_text_block(0x2102, "$GPVTG,90.5,T,80.5,M,2.0,N,3.7,K,A\r\n"));
  ASSERT_EQ(course.vtg.size(), 1U);
  EXPECT_DOUBLE_EQ(course.vtg[0].sentence.course_true_rad.value(), 90.5 * degree);
  EXPECT_DOUBLE_EQ(course.vtg[0].sentence.speed_mps.value(), 2 * knot);
  EXPECT_EQ(course.vtg[0].sentence.mode.value, 'A');
}

TEST(WinRiver, WithoutAFixThereIsNoPositionAndNoSpeed) {
  EXPECT_FALSE(read(gga(64.5, 'N', 0)).gga[0].sentence.latitude_rad);
  EXPECT_FALSE(read(gga(64.5, 'N', 0)).gga[0].sentence.mean_sea_level_height_m);
  EXPECT_FALSE(read(vtg('N')).vtg[0].sentence.speed_mps);
  const auto empty = read(as_text_block(0x2101, "$GPGGA,,,,,,0,0,0.0,,,,,0.0,0000\r\n"));
  EXPECT_FALSE(empty.gga[0].sentence.latitude_rad);
}

TEST(WinRiver, ANumberThatNoPlaceHasIsEmpty) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (const double latitude_deg : {none, 90.5, -1.0, std::numeric_limits<double>::infinity()})
    EXPECT_FALSE(read(gga(latitude_deg, 'N')).gga[0].sentence.latitude_rad) << latitude_deg;
  EXPECT_FALSE(read(gga(64.5, '?')).gga[0].sentence.latitude_rad);
}

TEST(WinRiver, WhatIsCutShortOrOfAnotherKindIsLeftToBeCounted) {
  const Buffer whole = gga(64.5, 'N');
  for (std::size_t size = 0; size < whole.size(); ++size)
    refused(Buffer(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)));
  refused(gga(64.5, 'N', 2, 105));  // a GGA that is called a VTG
  refused(gga(64.5, 'N', 2, 106));  // a depth sounder's
  refused(as_text_block(0x2101, "$GPVTG,90.5,T,80.5,M,2.0,N,3.7,K,A\r\n"));
  refused(as_text_block(0x2100, "$SDDBT,1,f,2,M,3,F\r\n"));
}

TEST(WinRiver, MoreThanAnEnsembleCanHoldAreLeftToBeCounted) {
  WinRiverSentences m;
  for (std::size_t i = 0; i < WinRiverSentences::most; ++i)
    ASSERT_TRUE(read_block(gga(64.5, 'N'), m));
  EXPECT_FALSE(read_block(gga(64.5, 'N'), m));
}

RC_GTEST_PROP(WinRiver, AnyBytesAreReadWithoutHarm, (const std::vector<std::uint8_t>& rest)) {
  const auto [id, kind] = *rc::gen::element(std::pair{0x2022, 104}, std::pair{0x2022, 105},
                                            std::pair{0x2101, 0}, std::pair{0x2102, 0});
  Block block;
  block.put(static_cast<std::uint16_t>(id)).put(static_cast<std::uint16_t>(kind));
  WinRiverSentences m;
  read_block(block.bytes + rest, m);
  for (const WinRiverGga& one : m.gga)
    RC_ASSERT(std::abs(one.sentence.latitude_rad.value_or(0)) <= 90 * degree);
}

/// The receiver's own text, with six decimals of a minute, and WinRiver's numbers.
struct Capture {
  const char* file;
  /// Counted by a few lines of Python over the offset tables: blocks with an address, and
  /// sentences that stand there in both forms. In 25 ensembles of winriver02, 1500 blocks have
  /// none: they hold old memory of WinRiver, such as its version and parts of the sentences before.
  std::size_t gga, vtg, pairs;
};

class WinRiverCapture : public ::testing::TestWithParam<Capture> {
 protected:
  void SetUp() override {
    const auto file = corpora() / "dvl/pd0/raw" / GetParam().file;
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no captures at " << corpora();
    for (const auto& message : read_stream<Pd0>(read_file(file)).messages)
      ensembles_.push_back(std::get<Pd0Ensemble>(message).winriver);
  }
  std::vector<WinRiverSentences> ensembles_;
};

TEST_P(WinRiverCapture, NumbersAndTextSayTheSamePosition) {
  constexpr double half_a_digit = 0.5e-6 / 60 * degree * 1.01;
  std::size_t numbers = 0, courses = 0, pairs = 0;
  for (const WinRiverSentences& ensemble : ensembles_) {
    for (const WinRiverVtg& one : ensemble.vtg) courses += one.delta_s ? 1 : 0;
    for (const WinRiverGga& one : ensemble.gga) numbers += one.delta_s ? 1 : 0;
    for (const WinRiverGga& text : ensemble.gga) {
      if (text.delta_s || !text.sentence.latitude_rad) continue;
      const auto same = std::ranges::find_if(ensemble.gga, [&](const WinRiverGga& one) {
        return one.delta_s && one.sentence.time_of_day == text.sentence.time_of_day;
      });
      if (same == ensemble.gga.end()) continue;
      ++pairs;
      const Gga &a = same->sentence, &b = text.sentence;
      EXPECT_NEAR(a.latitude_rad.value(), b.latitude_rad.value(), half_a_digit);
      EXPECT_NEAR(a.longitude_rad.value(), b.longitude_rad.value(), half_a_digit);
      EXPECT_NEAR(a.mean_sea_level_height_m.value(), b.mean_sea_level_height_m.value(), 0.0501);
      EXPECT_NEAR(a.horizontal_dop.value(), b.horizontal_dop.value(), 1e-6);
      EXPECT_NEAR(a.differential_age_s.value(), b.differential_age_s.value(), 1e-5);
      EXPECT_EQ(a.quality, b.quality);
      EXPECT_EQ(a.satellites_used, b.satellites_used);
      EXPECT_EQ(a.differential_station, b.differential_station);
    }
  }
  EXPECT_EQ(numbers, GetParam().gga);
  EXPECT_EQ(courses, GetParam().vtg);
  EXPECT_EQ(pairs, GetParam().pairs);
}

TEST_P(WinRiverCapture, EachCourseAsTextIsOneOfThoseInNumbers) {
  for (const WinRiverSentences& ensemble : ensembles_) {
    for (const WinRiverVtg& text : ensemble.vtg) {
      if (text.delta_s) continue;
      const Vtg& b = text.sentence;
      EXPECT_TRUE(std::ranges::any_of(ensemble.vtg, [&](const WinRiverVtg& one) {
        const Vtg& a = one.sentence;
        return one.delta_s && std::abs(*a.course_true_rad - *b.course_true_rad) < 0.0011 * degree &&
               std::abs(*a.course_magnetic_rad - *b.course_magnetic_rad) < 0.0011 * degree &&
               std::abs(*a.speed_mps - *b.speed_mps) < 0.0011 * knot;
      }));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Captures, WinRiverCapture,
    ::testing::Values(Capture{"winriver01.PD0", 34, 0, 34}, Capture{"winriver02.PD0", 611, 0, 50},
                      Capture{"tanana_transects_08_10_10_0_002_10-08-10_142214.PD0", 1599, 1598,
                              580}),
    [](const auto& capture) {
      const std::string_view file = capture.param.file;
      return std::string(file.substr(0, file.find_first_of("._")));
    });

}  // namespace pd0_winriver_test
}  // namespace drydock::wire::testing
