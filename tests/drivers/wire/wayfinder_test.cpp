#include "drivers/wire/dvl/wayfinder.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/wire/byte_streams.hpp"

namespace drydock::wire::testing {
namespace wayfinder_test {

using namespace std::chrono_literals;

/// The packets of fixtures/wayfinder/NOTE.md.
Reading<Wayfinder> wayfinder_golden() {
  return read_stream<Wayfinder>(fixture("wayfinder/golden.wayfinder"));
}
WayfinderPing golden_ping(std::size_t index) {
  return wayfinder_golden().all<WayfinderPing>().at(index);
}

TEST(Wayfinder, EveryFieldOfAPingStandsWhereTheMakersProgramsReadIt) {
  const WayfinderPing m = golden_ping(0);
  EXPECT_EQ(m.version, 0x10u);
  EXPECT_EQ(m.system_type, 76u);
  EXPECT_EQ(m.system_subtype, 1u);
  EXPECT_EQ(m.firmware, (std::array<unsigned, 4>{1, 2, 3, 4}));
  EXPECT_EQ(m.clock, std::chrono::sys_days{std::chrono::year{2026} / 11 / 22}.time_since_epoch() +
                         14h + 3min + 59s + 250ms);
  EXPECT_EQ(m.frame, DvlFrame::ship);
  EXPECT_EQ(m.velocity_mps, (DvlComponents{0.25, -1.5, 0.0625, 0.03125}));
  EXPECT_EQ(m.range_m, (DvlComponents{11.5, 12.0, 12.5, 13.0}));
  EXPECT_EQ(m.mean_range_m, 12.25);
  EXPECT_EQ(m.sound_speed_mps, 1500.5);
  EXPECT_EQ(m.status, 0x0102u);
  EXPECT_EQ(m.test_count, 3u);
  EXPECT_EQ(m.test_code, 4u);
  EXPECT_EQ(m.input_v, 24.5);
  EXPECT_EQ(m.transmit_v, 30.25);
  EXPECT_EQ(m.current_a, 0.125);
}

TEST(Wayfinder, WhatIsNotANumberIsEmpty) {
  const WayfinderPing m = golden_ping(1);
  EXPECT_EQ(m.version, 0x11u);
  EXPECT_EQ(m.frame, DvlFrame::beam);
  EXPECT_EQ(m.velocity_mps, DvlComponents{});
  EXPECT_EQ(m.range_m, (DvlComponents{std::nullopt, 8.0, std::nullopt, std::nullopt}));
  EXPECT_FALSE(m.mean_range_m || m.clock || m.transmit_v);
  EXPECT_EQ(m.sound_speed_mps, 1480.0);
}

TEST(Wayfinder, AxesThatNobodyKnowsAreNotMadeUp) {
  const WayfinderPing m = golden_ping(2);
  EXPECT_FALSE(m.frame || m.sound_speed_mps);
  EXPECT_EQ(m.velocity_mps[3], 4.0);
}

TEST(Wayfinder, AnAnswerTellsItsCommandAndEveryOtherPacketItsId) {
  const auto answers = wayfinder_golden().all<WayfinderAnswer>();
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].command, 0x1F000002u);
  EXPECT_EQ(answers[0].status, 1u);
  const auto others = wayfinder_golden().all<WayfinderOther>();
  ASSERT_EQ(others.size(), 3u);
  EXPECT_EQ(others[0].id, 3u);
  EXPECT_EQ(others[0].payload_bytes, 16u);
  EXPECT_EQ(others[1].id, 6u);
  EXPECT_EQ(others[2].payload_bytes, 40u);
}

TEST(Wayfinder, TheMakersSampleIsSoundAndADamagedOneIsNot) {
  Buffer sample = wayfinder_golden().frames.at(0);
  EXPECT_EQ(Wayfinder::scan(sample), Scan::frame(27));
  EXPECT_EQ(Wayfinder::scan(Bytes{sample}.first(5)), Scan::need_more(27));
  sample[20] ^= 1;
  EXPECT_EQ(Wayfinder::scan(sample), Scan::bad_checksum());
}

TEST(Wayfinder, ALengthThatNoPacketHasIsSkipped) {
  EXPECT_EQ(Wayfinder::scan(Buffer{0xAA, 0x10, 0x01, 0x0A, 0x00}), Scan::skip(1));
  EXPECT_EQ(Wayfinder::scan(Buffer{0xAA, 0x10, 0x01, 0xFF, 0xFF}), Scan::skip(1));
}

}  // namespace wayfinder_test
}  // namespace drydock::wire::testing
