#include "drivers/wire/dvl/pd4.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/wire/byte_streams.hpp"

namespace drydock::wire::testing {
namespace pd4_test {

using namespace std::chrono_literals;

/// The reports of fixtures/pd4/NOTE.md.
Pd4Report golden_pd4(std::size_t index) {
  return read_stream<Pd4>(fixture("pd4/golden.pd4")).all<Pd4Report>().at(index);
}
Pd5Report golden_pd5(std::size_t index) {
  return read_stream<Pd5>(fixture("pd5/golden.pd5")).all<Pd5Report>().at(index);
}

TEST(Pd4, VelocitiesAreTheVehiclesAsTheyAreOnTheWire) {
  const Pd4Report m = golden_pd4(0);
  EXPECT_EQ(m.frame, DvlFrame::instrument);
  EXPECT_FALSE(m.tilts_used || m.three_beam);
  EXPECT_EQ(m.frequency_hz, 600e3);
  EXPECT_EQ(m.bottom_velocity_mps, (DvlComponents{0.25, 1.5, -0.04, -0.003}));
  EXPECT_EQ(m.water_velocity_mps, (DvlComponents{0.1, -0.2, 0.3, -0.004}));
}

TEST(Pd4, EveryOtherFieldStandsWhereTheGuideSays) {
  const Pd4Report m = golden_pd4(0);
  EXPECT_EQ(m.bottom_range_m[0], 12.34);
  EXPECT_EQ(m.bottom_range_m[1], 13.0);
  EXPECT_FALSE(m.bottom_range_m[2]);
  EXPECT_EQ(m.bottom_range_m[3], 655.35);
  EXPECT_EQ(m.bottom_status, 0x10);
  EXPECT_EQ(m.layer_start_m, 2.0);
  EXPECT_EQ(m.layer_end_m, 14.5);
  EXPECT_EQ(m.water_status, 0);
  EXPECT_EQ(m.first_ping, 12h + 34min + 56s + 780ms);
  EXPECT_EQ(m.built_in_test, 0);
  EXPECT_EQ(m.sound_speed_mps, 1500.0);
  EXPECT_NEAR(*m.temperature_k, 285.49, 1e-9);
}

TEST(Pd4, WhatWasNotFoundIsEmpty) {
  const Pd4Report m = golden_pd4(1);
  EXPECT_EQ(m.frame, DvlFrame::earth);
  EXPECT_TRUE(m.tilts_used && m.three_beam);
  EXPECT_EQ(m.frequency_hz, 1200e3);
  EXPECT_EQ(m.bottom_velocity_mps, DvlComponents{});
  EXPECT_EQ(m.water_velocity_mps, DvlComponents{});
  EXPECT_EQ(m.bottom_range_m, DvlComponents{});
  EXPECT_EQ(m.built_in_test, 0x0105);
  EXPECT_FALSE(m.first_ping || m.sound_speed_mps || m.temperature_k);
}

TEST(Pd5, AddsSensorsAndDistances) {
  const Pd5Report m = golden_pd5(0);
  EXPECT_EQ(m.frame, DvlFrame::ship);
  EXPECT_TRUE(m.tilts_used);
  EXPECT_EQ(m.frequency_hz, 300e3);
  EXPECT_EQ(m.bottom_velocity_mps, (DvlComponents{-0.123, 2.045, 0.067, {}}));
  EXPECT_EQ(m.first_ping, 10ms);
  EXPECT_NEAR(*m.temperature_k, 271.65, 1e-9);
  EXPECT_EQ(m.salinity_ppt, 35);
  EXPECT_EQ(m.depth_m, 123.4);
  EXPECT_NEAR(degrees(*m.pitch_rad), 3.25, 1e-12);
  EXPECT_NEAR(degrees(*m.roll_rad), -10.15, 1e-12);
  EXPECT_NEAR(degrees(*m.heading_rad), 270.5, 1e-12);
  EXPECT_EQ(m.bottom_distance_m, (std::array{1234.5, -67.8, 0.9, -0.1}));
  EXPECT_EQ(m.water_distance_m, (std::array{0.1, 0.2, -0.3, 2e8}));
}

TEST(Pd5, SensorsThatAreNotThereAreEmpty) {
  const Pd5Report m = golden_pd5(1);
  EXPECT_EQ(m.frame, DvlFrame::beam);
  EXPECT_EQ(m.bottom_velocity_mps, (DvlComponents{-0.01, 0.02, {}, -0.04}));
  EXPECT_FALSE(m.heading_rad || m.pitch_rad || m.roll_rad);
}

TEST(Pd4, TheEncoderRebuildsTheGoldenReports) {
  Buffer written;
  std::array<std::uint8_t, Pd5::max_frame> out;
  const auto expect_rebuilt = [&](const auto& golden, const Buffer& stream) {
    written.clear();
    for (std::size_t i = 0; i < 2; ++i) {
      const std::size_t size = encode(golden(i), out);
      written.insert(written.end(), out.begin(), out.begin() + static_cast<long>(size));
      EXPECT_EQ(encode(golden(i), std::span{out}.first(size - 1)), 0u);
    }
    EXPECT_EQ(written, stream);
  };
  expect_rebuilt(golden_pd4, fixture("pd4/golden.pd4"));
  expect_rebuilt(golden_pd5, fixture("pd5/golden.pd5"));
}

TEST(Pd4, AVelocityBeyondTheWireIsHeldAtItsEndAndNotMarkedBad) {
  Pd4Report m;
  m.bottom_velocity_mps = {-40.0, 40.0, 0.0, 0.0};
  std::array<std::uint8_t, Pd4::max_frame> out;
  encode(m, out);
  const auto again = std::get<Pd4Report>(*Pd4::decode(out));
  EXPECT_EQ(again.bottom_velocity_mps[0], -32.767);
  EXPECT_EQ(again.bottom_velocity_mps[1], 32.767);
}

TEST(Pd4, TheOtherStructureIsNoFrame) {
  EXPECT_EQ(read_stream<Pd4>(fixture("pd5/golden.pd5")).frames.size(), 0u);
  EXPECT_EQ(read_stream<Pd5>(fixture("pd4/golden.pd4")).frames.size(), 0u);
}

}  // namespace pd4_test
}  // namespace drydock::wire::testing
