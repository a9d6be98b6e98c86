#include "drivers/wire/dvl/pd0.hpp"

#include <gtest/gtest.h>

#include "drivers/wire/bytes.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

namespace drydock::wire::testing {
namespace pd0_test {

using namespace std::chrono_literals;

/// The ensembles of fixtures/pd0/NOTE.md.
Pd0Ensemble golden(std::size_t index) {
  static const auto reading = read_stream<Pd0>(fixture("pd0/golden.pd0"));
  return std::get<Pd0Ensemble>(reading.messages.at(index));
}

TEST(Pd0, FixedLeaderTellsHowTheInstrumentIsBuilt) {
  const Pd0FixedLeader m = golden(0).fixed;
  EXPECT_EQ(m.firmware_version, 51);
  EXPECT_EQ(m.firmware_revision, 41);
  EXPECT_EQ(m.frequency_hz, 600e3);
  EXPECT_NEAR(degrees(*m.beam_angle_rad), 30, 1e-12);
  EXPECT_TRUE(m.convex);
  EXPECT_FALSE(m.faces_up);
  EXPECT_EQ(m.beams, 4);
  EXPECT_EQ(m.cells, 30);
  EXPECT_DOUBLE_EQ(m.cell_length_m, 1.0);
  EXPECT_DOUBLE_EQ(m.blank_m, 0.88);
  EXPECT_EQ(m.frame, DvlFrame::ship);
  EXPECT_FALSE(m.tilts_used);
  EXPECT_FALSE(m.three_beam);
  EXPECT_NEAR(degrees(m.heading_alignment_rad), 45, 1e-12);
  EXPECT_NEAR(degrees(m.heading_bias_rad), -1.87, 1e-12);
  EXPECT_EQ(m.sensors_available, 0x3D);
}

TEST(Pd0, VariableLeaderTellsWhenAndHowItLay) {
  const Pd0VariableLeader m = golden(0).variable;
  EXPECT_EQ(m.ensemble, 3u * 65536u + 17u);
  const auto midnight = std::chrono::local_days{std::chrono::year{2026} / 11 / 21};
  EXPECT_EQ(*m.clock, midnight + 12h + 34min + 56s + 780ms);
  EXPECT_EQ(m.sound_speed_mps, 1500.0);
  EXPECT_DOUBLE_EQ(m.depth_m, 123.4);
  EXPECT_NEAR(degrees(*m.heading_rad), 270.5, 1e-12);
  EXPECT_NEAR(degrees(*m.pitch_rad), 3.25, 1e-12);
  EXPECT_NEAR(degrees(*m.roll_rad), -10.15, 1e-12);
  EXPECT_EQ(m.salinity_ppt, 35.0);
  EXPECT_NEAR(*m.temperature_k, 12.34 + 273.15, 1e-12);
  EXPECT_DOUBLE_EQ(*m.pressure_pa, 1'234'560.0);
}

TEST(Pd0, BottomTrackVelocityIsTheVehiclesMotionNotTheBeds) {
  const auto track = golden(0).bottom_track;
  ASSERT_TRUE(track);
  EXPECT_DOUBLE_EQ(*track->velocity_mps[0], 0.25);
  EXPECT_DOUBLE_EQ(*track->velocity_mps[1], 1.5);
  EXPECT_DOUBLE_EQ(*track->velocity_mps[2], -0.04);
  EXPECT_DOUBLE_EQ(*track->velocity_mps[3], -0.003);
}

TEST(Pd0, RangesHave24Bits) {
  const auto track = golden(0).bottom_track;
  EXPECT_DOUBLE_EQ(*track->range_m[0], 12.34);
  EXPECT_DOUBLE_EQ(*track->range_m[2], 700.0);
  EXPECT_DOUBLE_EQ(*track->range_m[3], 1310.77);
  EXPECT_EQ(track->correlation, (std::array<std::uint8_t, 4>{255, 254, 253, 252}));
  EXPECT_EQ(track->amplitude, (std::array<std::uint8_t, 4>{103, 75, 86, 89}));
  EXPECT_EQ(track->percent_good, (std::array<std::uint8_t, 4>{100, 99, 98, 97}));
  EXPECT_DOUBLE_EQ(*track->max_depth_m, 200.0);
}

TEST(Pd0, BadBeamsAreEmptyAndSpareTheOthers) {
  const auto track = golden(1).bottom_track;
  ASSERT_TRUE(track);
  EXPECT_DOUBLE_EQ(*track->velocity_mps[0], -0.025);
  EXPECT_FALSE(track->velocity_mps[1]);
  EXPECT_DOUBLE_EQ(*track->velocity_mps[2], -0.016);
  EXPECT_FALSE(track->velocity_mps[3]);
  EXPECT_DOUBLE_EQ(*track->range_m[0], 7.79);
  EXPECT_FALSE(track->range_m[1]);
}

TEST(Pd0, OffsetsDecideWhereABlockStandsAndEnds) {
  const Pd0Ensemble m = golden(1);
  EXPECT_EQ(m.fixed.frame, DvlFrame::earth);
  EXPECT_TRUE(m.fixed.tilts_used);
  EXPECT_TRUE(m.fixed.three_beam);
  EXPECT_EQ(m.variable.ensemble, 42u);
  EXPECT_NEAR(degrees(*m.variable.heading_rad), 27.34, 1e-12);
  EXPECT_EQ(m.variable.clock->time_since_epoch(),
            std::chrono::local_days{std::chrono::year{2024} / 2 / 29}.time_since_epoch() + 23h +
                59min + 59s + 990ms);
}

/// As Teledyne's manuals say of the command TS.
TEST(Pd0, AYearWithoutItsCenturyIsFrom1990To2089) {
  const auto frames = read_stream<Pd0>(fixture("pd0/golden.pd0")).frames;
  Buffer frame = frames.at(0);
  const std::size_t block = load_le<std::uint16_t>(frame, 8);  // behind the fixed leader
  ASSERT_EQ(load_le<std::uint16_t>(frame, block), 0x0080);
  frame[block + 57] = 0;  // no century
  for (const auto& [digits, year] : {std::pair{99, 1999}, {90, 1990}, {89, 2089}, {0, 2000}}) {
    frame[block + 4] = static_cast<std::uint8_t>(digits);
    const auto m = std::get<Pd0Ensemble>(Pd0::decode(frame).value());
    const std::chrono::year_month_day date{
        std::chrono::floor<std::chrono::days>(m.variable.clock.value())};
    EXPECT_EQ(date.year(), std::chrono::year{year});
  }
}

TEST(Pd0, PressureMayBeSlightlyBelowZero) {
  EXPECT_DOUBLE_EQ(*golden(1).variable.pressure_pa, -1320.0);
}

TEST(Pd0, SensorsThatAreNotThereAreEmpty) {
  const Pd0Ensemble m = golden(2);
  EXPECT_FALSE(m.bottom_track);
  EXPECT_FALSE(m.variable.heading_rad || m.variable.pitch_rad || m.variable.roll_rad);
  EXPECT_FALSE(m.variable.temperature_k || m.variable.pressure_pa || m.variable.clock);
  EXPECT_FALSE(m.variable.sound_speed_mps);
  EXPECT_NEAR(degrees(*m.fixed.beam_angle_rad), 15, 1e-12);
}

TEST(Pd0, HighResolutionIsTheVehiclesMotionOnTheWireToo) {
  const auto fine = golden(3).high_resolution;
  ASSERT_TRUE(fine);
  EXPECT_DOUBLE_EQ(*fine->bottom_velocity_mps[0], 0.25012);
  EXPECT_FALSE(fine->bottom_velocity_mps[1]);
  EXPECT_DOUBLE_EQ(*fine->bottom_velocity_mps[2], -0.03998);
  EXPECT_DOUBLE_EQ(*fine->bottom_velocity_mps[3], -0.00301);
  EXPECT_DOUBLE_EQ(*fine->bottom_distance_m[0], 12.34567);
  EXPECT_DOUBLE_EQ(*fine->bottom_distance_m[1], -0.00089);
  EXPECT_DOUBLE_EQ(*fine->water_velocity_mps[2], -0.003);
  EXPECT_FALSE(fine->water_velocity_mps[3]);
  EXPECT_DOUBLE_EQ(*fine->water_distance_m[3], 4e-5);
}

TEST(Pd0, RangesToTheBedInTenthsOfAMillimetre) {
  const auto range = golden(3).bottom_range;
  ASSERT_TRUE(range);
  EXPECT_DOUBLE_EQ(*range->slant_range_m, 13.0001);
  EXPECT_DOUBLE_EQ(*range->axis_difference_m, -0.0025);
  EXPECT_DOUBLE_EQ(*range->vertical_range_m, 12.6543);
  EXPECT_DOUBLE_EQ(*range->beam_range_m[2], 12.8003);
  EXPECT_FALSE(range->beam_range_m[3]);
}

TEST(Pd0, TheAgeOfTheEchoesIsTheMeanOfTheGoodBeams) {
  const auto navigation = golden(3).navigation;
  ASSERT_TRUE(navigation);
  EXPECT_EQ(navigation->echo_age[2], 155ms);
  EXPECT_FALSE(navigation->echo_age[3]);
  EXPECT_EQ(age_of(*navigation), 152ms);
  EXPECT_FALSE(age_of(Pd0Navigation{}));
}

TEST(Pd0, AnEnsembleWithoutLeadersHoldsNoMessage) {
  const auto reading = read_stream<Pd0>(fixture("pd0/golden.pd0"));
  EXPECT_FALSE(Pd0::decode(reading.frames.at(3)));
}

TEST(Pd0, TheEncoderRebuildsTheGoldenEnsembles) {
  const auto frames = read_stream<Pd0>(fixture("pd0/golden.pd0")).frames;
  std::array<std::uint8_t, 512> out;
  const std::size_t size = encode(golden(0), out);
  EXPECT_EQ(Buffer(out.begin(), out.begin() + static_cast<long>(size)), frames[0]);
}

TEST(Pd0, ABeamAngleWithoutABitPatternStandsInTheLastByteOfTheFixedLeader) {
  Pd0Ensemble m = golden(0);
  m.fixed.beam_angle_rad = radians(25);
  std::array<std::uint8_t, 512> out;
  const std::size_t size = encode(m, out);
  constexpr std::size_t fixed_at = 12;  // header, three offsets
  EXPECT_EQ(out[fixed_at + 5] & 3, 3) << "other";
  EXPECT_EQ(out[fixed_at + 58], 25);
  const auto again = std::get<Pd0Ensemble>(*Pd0::decode(Bytes{out}.first(size)));
  EXPECT_NEAR(degrees(*again.fixed.beam_angle_rad), 25, 1e-12);
}

TEST(Pd0, WhatIsAbsentIsMarkedAbsent) {
  std::array<std::uint8_t, 512> out;
  const std::size_t size = encode(golden(2), out);
  const auto again = std::get<Pd0Ensemble>(*Pd0::decode(Bytes{out}.first(size)));
  EXPECT_FALSE(again.variable.heading_rad || again.variable.pitch_rad || again.variable.roll_rad);
  EXPECT_FALSE(again.variable.temperature_k || again.variable.pressure_pa);
  EXPECT_FALSE(again.bottom_track);
}

TEST(Pd0, AVelocityBeyondTheWireIsHeldAtItsEndAndNotMarkedBad) {
  Pd0Ensemble m = golden(0);
  m.bottom_track->velocity_mps[0] = 40.0;
  std::array<std::uint8_t, 512> out;
  const std::size_t size = encode(m, out);
  const auto again = std::get<Pd0Ensemble>(*Pd0::decode(Bytes{out}.first(size)));
  EXPECT_DOUBLE_EQ(*again.bottom_track->velocity_mps[0], 32.767);
}

TEST(Pd0, ClaimsThatCannotBeAreSkipped) {
  EXPECT_EQ(Pd0::scan(Buffer{0x7F, 0x7F, 0x7F, 0x7F, 0x00, 0x03}), Scan::skip(1)) << "too long";
  EXPECT_EQ(Pd0::scan(Buffer{0x7F, 0x7F, 0x07, 0x00, 0x00, 0x03}), Scan::skip(1)) << "too short";
  EXPECT_EQ(Pd0::scan(Buffer{0x7F, 0x7F, 0x80, 0x00, 0x00, 0x00}), Scan::skip(1)) << "no types";
}

TEST(Pd0, TheEncoderRefusesABufferThatIsTooSmall) {
  std::array<std::uint8_t, 218> out;
  EXPECT_EQ(encode(golden(0), out), 0u);
}

}  // namespace pd0_test
}  // namespace drydock::wire::testing
