#include "drivers/wire/dvl/pd6.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/drivers/wire/byte_streams.hpp"

namespace drydock::wire::testing {
namespace pd6_test {

using namespace std::chrono_literals;

Reading<Pd6> golden_lines() { return read_stream<Pd6>(fixture("pd6/golden.pd6")); }

/// The lines of that type in fixtures/pd6/NOTE.md.
template <class M>
M golden(std::size_t index = 0) {
  return golden_lines().all<M>().at(index);
}

TEST(Pd6, AttitudeAndTiming) {
  const auto attitude = golden<Pd6Attitude>();
  EXPECT_NEAR(degrees(*attitude.pitch_rad), 3.25, 1e-12);
  EXPECT_NEAR(degrees(*attitude.roll_rad), -10.15, 1e-12);
  EXPECT_NEAR(degrees(*attitude.heading_rad), 270.5, 1e-12);
  const auto timing = golden<Pd6Timing>();
  EXPECT_EQ(*timing.clock,
            std::chrono::local_days{std::chrono::year{2026} / 11 / 21} + 12h + 34min + 56s + 780ms);
  EXPECT_EQ(timing.salinity_ppt, 35.0);
  EXPECT_NEAR(*timing.temperature_k, 285.45, 1e-9);
  EXPECT_EQ(timing.depth_m, 123.4);
  EXPECT_EQ(timing.sound_speed_mps, 1500.0);
  EXPECT_EQ(golden<Pd6Timing>(1).built_in_test, 12u);
}

TEST(Pd6, ASensorAtTheSurfaceMayReadALittleAboveIt) {
  for (const auto& [text, depth_m] : {std::pair(" -0.05", -0.05), {"  -0.1", -0.1}}) {
    const auto line = ":TS,26112112345678,35.0,+12.3," + std::string(text) + ",1500.0,  0\r\n";
    const auto reading = read_stream<Pd6>(as_bytes(line));
    ASSERT_EQ(reading.all<Pd6Timing>().size(), 1u) << line;
    EXPECT_EQ(reading.all<Pd6Timing>()[0].depth_m, depth_m);
  }
}

TEST(Pd6, AClockThatIsNotSetIsNoDate) {
  EXPECT_FALSE(golden<Pd6Timing>(1).clock);
  EXPECT_FALSE(golden<Pd6Timing>(1).sound_speed_mps);
}

TEST(Pd6, VelocitiesOverTheBedAndAgainstTheWaterAreNotMixedUp) {
  EXPECT_EQ(golden<Pd6BottomInstrument>().velocity_mps, (DvlComponents{0.25, 1.5, -0.04, -0.003}));
  EXPECT_EQ(golden<Pd6BottomShip>().velocity_mps, (DvlComponents{0.251, 1.501, -0.041, {}}));
  EXPECT_EQ(golden<Pd6BottomEarth>().velocity_mps, (DvlComponents{-1.499, 0.3, -0.06, {}}));
  EXPECT_EQ((golden<Pd6Velocity<'W', 'I'>>().velocity_mps),
            (DvlComponents{0.1, -0.2, 0.3, -0.004}));
  EXPECT_EQ((golden<Pd6Velocity<'W', 'E'>>().velocity_mps[2]), 0.32);
}

TEST(Pd6, DistancesMadeGoodAndRange) {
  const auto m = golden<Pd6BottomDistance>();
  EXPECT_EQ(m.distance_m, (std::array{1234.5, -67.8, 9.1}));
  EXPECT_EQ(m.range_m, 12.8);
  EXPECT_EQ(golden<Pd6Distance<'W'>>().since_good_s, 0.5);
  EXPECT_FALSE(golden<Pd6BottomDistance>(1).range_m);
  EXPECT_EQ(golden<Pd6BottomDistance>(1).since_good_s, 12.5);
}

TEST(Pd6, WithoutLockThereIsNoVelocity) {
  const auto m = golden<Pd6BottomInstrument>(1);
  EXPECT_FALSE(m.good);
  EXPECT_EQ(m.velocity_mps, DvlComponents{});
  const auto three_beams = golden<Pd6BottomInstrument>(2);
  EXPECT_TRUE(three_beams.good);
  EXPECT_EQ(three_beams.velocity_mps, (DvlComponents{0.249, 1.499, -0.039, {}}));
}

/// A NavQuest says I where Teledyne's guide has V.
TEST(Pd6, AnInvalidVelocityMayBeCalledSo) {
  const auto reading = read_stream<Pd6>(as_bytes(":WI,+00000,+00000,+00000,+00000,I\r\n"));
  ASSERT_EQ((reading.all<Pd6Velocity<'W', 'I'>>().size()), 1u);
  EXPECT_FALSE((reading.all<Pd6Velocity<'W', 'I'>>()[0].good));
  EXPECT_EQ((reading.all<Pd6Velocity<'W', 'I'>>()[0].velocity_mps), DvlComponents{});
}

TEST(Pd6, ALineThatIsNotAsDocumentedIsDamaged) {
  for (const char* line :
       {":BI,  +123,  -420, +2000,    +0\r\n",                  // no status
        ":BI,  +123,  -420, +2000,    +0,X\r\n",                // no such status
        ":BI,  +123,  -420, +2000,A\r\n",                       // a field is missing
        ":BI,  +123,  -420, +2000,    +0,A,A\r\n",              // one too many
        ":BI,  +123,  -42o, +2000,    +0,A\r\n",                // not a number
        ":BI,  +123,      , +2000,    +0,A\r\n",                // empty
        ":BI,+99123,  -420, +2000,    +0,A\r\n",                // beyond 16 bits
        ":BI,  +123,  -420, +2000,    +0,A\rX",                 // no line end
        ":SA, +3.25,-10.15,370.50\r\n",                         // not a heading
        ":SA, +93.2,-10.15,270.50\r\n",                         // not a pitch
        ":TS,2611211234567,35.0,+12.3, 123.4,1500.0,  0\r\n",   // a digit is missing
        ":TS,261121123456.8,35.0,+12.3, 123.4,1500.0,  0\r\n",  // a digit is damaged
        ":TS,26112112345678,35.0,+12.3, -10.5,1500.0,  0\r\n",  // less than no pressure
        ":BD,  +1,  -6,  +9, -12.80,  0.00\r\n",                // below the bed
        ":BI,  +123,  -4:SA, +0.00, +0.00,  0.00\r\n"}) {       // torn
    const auto reading = read_stream<Pd6>(as_bytes(line));
    EXPECT_TRUE(reading.all<Pd6BottomInstrument>().empty()) << line;
    EXPECT_EQ(reading.counters.bad_checksums, 1u) << line;
  }
}

TEST(Pd6, LinesThatAreNotKnownArePassedOverAsAWhole) {
  const auto reading = read_stream<Pd6>(as_bytes(":RA, 123.45, 128.0\r\n"));
  EXPECT_EQ(reading.frames.size(), 1u);
  EXPECT_TRUE(reading.messages.empty());
}

TEST(Pd6, TheEncoderRebuildsTheGoldenLines) {
  const Buffer stream = fixture("pd6/golden.pd6");
  const std::string_view text = as_text(stream);
  for (const auto& message : golden_lines().messages) {
    std::array<std::uint8_t, Pd6::max_frame> out;
    const std::size_t size = encode(message, out);
    const auto line = as_text(Bytes{out.data(), size});
    EXPECT_NE(text.find(line.substr(0, line.size() - 2)), text.npos) << line;
    EXPECT_TRUE(line.ends_with("\r\n"));
    EXPECT_EQ(encode(message, std::span{out}.first(size - 1)), 0u);
  }
}

TEST(Pd6, WhatRoundsToZeroHasNoMinus) {
  Pd6BottomEarth m{true, {-0.0004, 0.0004, 0.0, {}}};
  std::array<std::uint8_t, Pd6::max_frame> out;
  EXPECT_EQ(as_text(Bytes{out.data(), encode(m, out)}), ":BE,    +0,    +0,    +0,A\r\n");
}

/// The example of Water Linked's documentation. The test reads it and, for valid values, writes it
/// again character by character (its "bad" is a zero, Teledyne's is -32768).
TEST(Pd6, TheExampleOfWaterLinkedIsReadAndRebuilt) {
  const auto file = corpora() / "dvl/waterlinked/pd6_example.txt";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no captures at " << corpora();
  const Buffer bytes = read_file(file);
  const auto reading = read_stream<Pd6>(bytes);
  ASSERT_EQ(reading.messages.size(), 10u);
  EXPECT_EQ(reading.counters.bytes_good, bytes.size());
  EXPECT_EQ(reading.all<Pd6BottomInstrument>().at(0).velocity_mps,
            (DvlComponents{0.123, -0.42, 2.0, 0.0}));
  EXPECT_EQ(reading.all<Pd6BottomShip>().at(0).velocity_mps,
            (DvlComponents{-0.42, 0.123, 2.0, {}}));
  EXPECT_FALSE(reading.all<Pd6BottomEarth>().at(0).good);
  EXPECT_EQ(reading.all<Pd6BottomDistance>().at(0).range_m, 5.32);
  EXPECT_EQ(*reading.all<Pd6Timing>().at(0).clock,
            std::chrono::local_days{std::chrono::year{2022} / 2 / 8} + 12h + 6min + 18s);
  std::size_t rebuilt = 0;
  for (const auto& message : reading.messages) {
    std::array<std::uint8_t, Pd6::max_frame> out;
    const std::size_t size = encode(message, out);
    const std::string line = std::string{as_text(Bytes{out.data(), size - 2})} + "\n";
    rebuilt += as_text(bytes).find(line) != std::string_view::npos;
  }
  EXPECT_EQ(rebuilt, 6u) << "SA, TS, WD, BI, BS, BD";
}

}  // namespace pd6_test
}  // namespace drydock::wire::testing
