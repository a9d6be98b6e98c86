#include "drivers/wire/dvl/nortek_ad2cp.hpp"

#include <gtest/gtest.h>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/dvl/ad2cp_frame.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

namespace drydock::wire::testing {
namespace nortek_ad2cp_test {

using namespace std::chrono_literals;
using namespace ad2cp;

/// The records of fixtures/nortek-ad2cp/NOTE.md.
Reading<NortekAd2cp> ad2cp_golden() {
  return read_stream<NortekAd2cp>(fixture("nortek-ad2cp/golden.nortek-ad2cp"));
}
BottomTrack golden_track(std::size_t index) { return ad2cp_golden().all<BottomTrack>().at(index); }
SignatureBottomTrack golden_signature(std::size_t index) {
  return ad2cp_golden().all<SignatureBottomTrack>().at(index);
}

Buffer golden_frame_of_signature() {
  for (const Buffer& frame : ad2cp_golden().frames)
    if (frame[2] == 0x17) return frame;
  return {};
}

void expect_near(const Four& ours, const std::array<double, 4>& theirs) {
  for (std::size_t i = 0; i < 4; ++i) {
    ASSERT_TRUE(ours[i]) << i;
    EXPECT_NEAR(*ours[i], theirs[i], 1e-6) << i;
  }
}

TEST(NortekAd2cp, TheSumsOfRealRecordsAreThoseOfTheGuide) {
  // The header of a DVL333's record, and an odd last byte counts as the high byte of its word.
  const Buffer header{0xA5, 0x0A, 0x1B, 0x10, 0xD4, 0x00, 0x21, 0xCC};
  EXPECT_EQ(word_sum(header), 0x9D41);
  EXPECT_EQ(word_sum({}), 0xB58C);
  EXPECT_EQ(word_sum(Buffer{0x01}), 0xB68C);
  EXPECT_EQ(word_sum(Buffer{0xFF, 0xFF, 0x02}), 0xB78B);
}

TEST(NortekAd2cp, AHeaderTellsItsLengthAndAWrongSumOfItIsSeenAtOnce) {
  Buffer header{0xA5, 0x0A, 0x1B, 0x10, 0xD4, 0x00, 0x21, 0xCC, 0x41, 0x9D};
  EXPECT_EQ(NortekAd2cp::scan(header), Scan::need_more(222));
  header[4] ^= 0x10;
  EXPECT_EQ(NortekAd2cp::scan(header), Scan::bad_checksum());
}

TEST(NortekAd2cp, ARecordLongerThanAnyBottomTrackIsSkipped) {
  Buffer header{0xA5, 0x0C, 0x23, 0x10, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0, 0};
  const unsigned sum = word_sum(Bytes{header}.first(10));
  header[10] = static_cast<std::uint8_t>(sum);
  header[11] = static_cast<std::uint8_t>(sum >> 8);
  EXPECT_EQ(NortekAd2cp::scan(header), Scan::skip(1));
}

TEST(NortekAd2cp, EveryFieldOfABottomTrackStandsWhereTheManualSays) {
  const BottomTrack m = golden_track(0);
  EXPECT_EQ(m.version, 1u);
  EXPECT_EQ(m.serial_number, 105236u);
  EXPECT_EQ(m.clock, std::chrono::sys_days{std::chrono::year{2026} / 11 / 22}.time_since_epoch() +
                         14h + 3min + 59s + 500us);
  EXPECT_EQ(m.number_of_beams, 4u);
  EXPECT_EQ(m.error, 0u);
  EXPECT_EQ(m.status, 0x100FFFFFu);
  EXPECT_EQ(m.sound_speed_mps, 1500.25);
  EXPECT_NEAR(*m.temperature_k, 278.775, 1e-9);
  EXPECT_NEAR(*m.pressure_pa, 12'500, 1e-9);
  expect_near(m.beams.velocity_mps, {0.25, 0.125, -0.25, -0.125});
  expect_near(m.distance_m, {3.5, 4.0, 4.5, 5.0});
  expect_near(m.beams.figure_of_merit_mps, {0.001, 0.002, 0.003, 0.004});
  expect_near(m.beams.after_trigger_s, {0.015, 0.016, 0.017, 0.018});
  expect_near(m.beams.after_output_s, {-0.635, -0.634, -0.633, -0.632});
  expect_near(m.beams.duration_s, {0.009, 0.0095, 0.01, 0.0105});
  expect_near(m.axes.velocity_mps, {0.75, 0.0625, -0.03125, 0.0469});
  expect_near(m.axes.figure_of_merit_mps, {0.0021, 0.0022, 0.0012, 0.0024});
  expect_near(m.axes.after_trigger_s, {0.0161, 0.0162, 0.0163, 0.0164});
  expect_near(m.axes.after_output_s, {-0.6341, -0.6342, -0.6343, -0.6344});
  expect_near(m.axes.duration_s, {0.0091, 0.0092, 0.0093, 0.0094});
}

TEST(NortekAd2cp, WhatTheStatusDoesNotVouchForIsEmptyWithItsTimes) {
  const BottomTrack m = golden_track(1);
  EXPECT_FALSE(m.beams.velocity_mps[0] || m.distance_m[0] || m.beams.figure_of_merit_mps[0]);
  EXPECT_FALSE(m.axes.velocity_mps[3] || m.axes.figure_of_merit_mps[3]);
  EXPECT_FALSE(m.axes.after_trigger_s[3] || m.axes.after_output_s[3] || m.axes.duration_s[3]);
  EXPECT_NEAR(*m.axes.velocity_mps[2], -0.021, 1e-6);
  EXPECT_NEAR(*m.distance_m[3], 6.75, 1e-6);
  const BottomTrack lost = golden_track(2);
  EXPECT_EQ(lost.status, 0x20000000u);
  EXPECT_EQ(lost.distance_m, Four{});
  EXPECT_EQ(lost.axes.velocity_mps, Four{});
  EXPECT_EQ(lost.beams.after_output_s, Four{});
}

TEST(NortekAd2cp, TheOffsetOfTheDataIsObeyedAndNoTimeOrTemperatureIsMadeUp) {
  const BottomTrack m = golden_track(3);
  expect_near(m.beams.velocity_mps, {1, 2, 3, 4});
  expect_near(m.axes.duration_s, {141, 142, 143, 144});
  EXPECT_FALSE(m.clock || m.temperature_k);
  EXPECT_EQ(m.error, 3u);
}

TEST(NortekAd2cp, WaterTrackIsToldByItsIdAlone) {
  const auto all = ad2cp_golden().all<WaterTrack>();
  ASSERT_EQ(all.size(), 1u);
  expect_near(all[0].axes.velocity_mps, {0.75, 0.0625, -0.03125, 0.0469});
}

TEST(NortekAd2cp, ASignaturesBottomTrackIsIntegersWithAnExponent) {
  const SignatureBottomTrack m = golden_signature(0);
  EXPECT_EQ(m.version, 1u);
  EXPECT_EQ(m.serial_number, 100123u);
  EXPECT_EQ(m.clock, std::chrono::sys_days{std::chrono::year{2026} / 1 / 31}.time_since_epoch() +
                         23h + 59min + 59s + 999900us);
  EXPECT_NEAR(*m.sound_speed_mps, 1501.2, 1e-9);
  EXPECT_NEAR(*m.temperature_k, 271.9, 1e-9);
  EXPECT_NEAR(*m.pressure_pa, 203'450, 1e-6);
  EXPECT_NEAR(degrees(*m.heading_rad), 270.5, 1e-9);
  EXPECT_NEAR(degrees(*m.pitch_rad), 3.25, 1e-9);
  EXPECT_NEAR(degrees(*m.roll_rad), -10.15, 1e-9);
  EXPECT_NEAR(m.battery_v, 16.3, 1e-9);
  EXPECT_NEAR(m.ambiguity_velocity_mps, 5.25, 1e-9);
  EXPECT_EQ(m.ensemble, 4711u);
  EXPECT_EQ(m.status, 0x10000000u);
  EXPECT_EQ(m.number_of_beams, 4u);
  EXPECT_EQ(m.axes, Axes::beam);
  expect_near(m.velocity_mps, {1.234, -0.567, -1.23, 0.571});
  expect_near(m.distance_m, {20.12, 20.34, 19.98, 20.001});
  EXPECT_EQ(m.figure_of_merit[3], 15u);
}

TEST(NortekAd2cp, ASignatureWithoutBottomGivesNoVelocity) {
  const SignatureBottomTrack m = golden_signature(1);
  EXPECT_EQ(m.velocity_mps, Four{});
  EXPECT_EQ(m.distance_m, Four{});
  EXPECT_FALSE(m.figure_of_merit[0]);
  const SignatureBottomTrack three = golden_signature(2);
  EXPECT_EQ(three.axes, Axes::instrument);
  EXPECT_EQ(three.number_of_beams, 3u);
  EXPECT_FALSE(three.velocity_mps[0] || three.velocity_mps[2] || three.velocity_mps[3]);
  EXPECT_NEAR(*three.velocity_mps[1], -0.2, 1e-9);
  EXPECT_FALSE(three.pressure_pa || three.temperature_k || three.heading_rad || three.pitch_rad);
}

TEST(NortekAd2cp, EveryOtherRecordIsCountedByItsName) {
  std::vector<std::string> names;
  for (const Other& m : ad2cp_golden().all<Other>()) names.emplace_back(m.type);
  EXPECT_EQ(names, (std::vector<std::string>{"text", "raw_echosounder", "burst", "other",
                                             "nucleus_bottom_track", "other", "other"}));
  const Other echo = ad2cp_golden().all<Other>().at(1);
  EXPECT_EQ(echo.id, 0x23u);
  EXPECT_EQ(echo.data_bytes, 1723u);
}

TEST(NortekAd2cp, TheBannerOfADataPortIsSkippedAndCounted) {
  const Buffer banner = as_bytes("\r\nNortek DVL1000 Data Interface\r\n");
  const Buffer golden = fixture("nortek-ad2cp/golden.nortek-ad2cp");
  const auto reading = read_stream<NortekAd2cp>(banner + golden);
  EXPECT_EQ(reading.frames.size(), 15u);
  EXPECT_EQ(reading.counters.bytes_skipped, banner.size());
  EXPECT_EQ(reading.counters.bad_checksums, 0u);
}

TEST(NortekAd2cp, AWholeRecordIsWrittenToTheLastBitAsTheDvlSendsIt) {
  const auto golden = ad2cp_golden();
  Buffer out(track_record_size);
  ASSERT_EQ(encode(golden.all<BottomTrack>().at(0), out), track_record_size);
  EXPECT_EQ(out, golden.frames[0]);
  ASSERT_EQ(encode(golden.all<WaterTrack>().at(0), out), track_record_size);
  EXPECT_EQ(out, golden.frames[4]);
  EXPECT_EQ(encode(golden_track(0), std::span{out}.first(221)), 0u);
}

/// Offsets of the Signature Integrator's Guide, from the first byte of the data.
TEST(NortekAd2cp, ASignaturesBottomTrackIsWrittenWhereTheGuideSays) {
  SignatureBottomTrack m = golden_signature(0);
  m.axes = Axes::instrument;
  m.velocity_mps[3].reset();
  m.distance_m[3].reset();
  Buffer out(signature_record_size);
  ASSERT_EQ(encode(m, out), signature_record_size);
  EXPECT_EQ(NortekAd2cp::scan(out), Scan::frame(signature_record_size));
  const Buffer golden = golden_frame_of_signature();
  EXPECT_TRUE(std::equal(out.begin() + 14, out.begin() + 40, golden.begin() + 14))
      << "serial number, clock, sensors";
  EXPECT_EQ(load_le<std::uint16_t>(out, 10 + 2), 0x012F) << "bits 0 to 3, 5, 8";
  EXPECT_EQ(load_le<std::uint16_t>(out, 10 + 30), 4 << 12 | 1 << 10);
  EXPECT_EQ(static_cast<std::int8_t>(out[10 + 60]), -4);
  EXPECT_EQ(load_le<std::uint32_t>(out, 10 + 52), 52500u);
  EXPECT_EQ(load_le<std::int32_t>(out, 10 + 78), 12340);
  EXPECT_EQ(load_le<std::int32_t>(out, 10 + 78 + 12), -52500) << "no bottom";
  EXPECT_EQ(load_le<std::int32_t>(out, 10 + 94), 20120);
  EXPECT_EQ(load_le<std::int32_t>(out, 10 + 94 + 12), -1022) << "no bottom";
  const auto back = std::get<SignatureBottomTrack>(NortekAd2cp::decode(out).value());
  EXPECT_EQ(back.velocity_mps[3], std::nullopt);
  EXPECT_NEAR(*back.velocity_mps[1], -0.567, 1e-9);
  EXPECT_EQ(encode(m, std::span{out}.first(signature_record_size - 1)), 0u);
}

/// The data up to the times, and the velocities of the axes with their merits. The rubbish in the
/// times of a missing velocity is not kept.
void expect_written_but_for_times(std::size_t index) {
  Buffer out(track_record_size);
  ASSERT_EQ(encode(golden_track(index), out), track_record_size);
  const Buffer expected = ad2cp_golden().frames[index];
  EXPECT_TRUE(std::equal(out.begin() + 10, out.begin() + 94, expected.begin() + 10));
  EXPECT_TRUE(std::equal(out.begin() + 142, out.begin() + 174, expected.begin() + 142));
}

TEST(NortekAd2cp, MissingValuesAreWrittenWithTheirMarksAndStatus) {
  expect_written_but_for_times(1);
  expect_written_but_for_times(2);
}

}  // namespace nortek_ad2cp_test
}  // namespace drydock::wire::testing
