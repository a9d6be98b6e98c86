#include "drivers/wire/dvl/nortek.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/drivers/wire/byte_streams.hpp"

namespace drydock::wire::testing {
namespace nortek_test {

using namespace std::chrono_literals;

/// The sentences of fixtures/nortek/make_golden.py.
Reading<Nortek> nortek_golden() { return read_stream<Nortek>(fixture("nortek/golden.nmea")); }

TEST(Nortek, VelocityPlainAndTaggedSayTheSame) {
  const auto all = nortek_golden().all<NortekVelocity>();
  ASSERT_EQ(all.size(), 5u);
  for (std::size_t i = 0; i < 4; ++i) {
    const NortekVelocity& m = all[i];
    EXPECT_EQ(m.ping_time_s, 1795262400.25);
    EXPECT_DOUBLE_EQ(*m.after_trigger_s, 0.06125);
    EXPECT_DOUBLE_EQ(*m.after_sentence_s, -0.0755);
    EXPECT_EQ(m.velocity_mps, (std::array<std::optional<double>, 3>{1.2345, -0.056, 0.078}));
    EXPECT_EQ(m.figure_of_merit_mps, 0.0031);
    EXPECT_EQ(m.distance_m, (std::array<std::optional<double>, 4>{7.01, 7.02, {}, 7.04}));
    const bool with_state = i % 2 == 1;
    EXPECT_EQ(m.status.has_value(), with_state);
    if (!with_state) continue;
    EXPECT_EQ(m.status, 0xF00Fu);
    EXPECT_EQ(m.battery_v, 23.4);
    EXPECT_EQ(m.sound_speed_mps, 1489.2);
    EXPECT_NEAR(*m.temperature_k, 283.65, 1e-9);
  }
}

TEST(Nortek, TheMarksOfNoBottomAreEmpty) {
  const auto m = nortek_golden().all<NortekVelocity>().at(4);
  for (const auto& component : m.velocity_mps) EXPECT_FALSE(component);
  for (const auto& distance : m.distance_m) EXPECT_FALSE(distance);
  EXPECT_FALSE(m.figure_of_merit_mps);
}

TEST(Nortek, OneBeam) {
  const auto all = nortek_golden().all<NortekBeam>();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].beam, 2);
  EXPECT_EQ(all[0].time_of_day, 11h + 40min + 250ms);
  EXPECT_EQ(all[0].velocity_mps, -0.512);
  EXPECT_EQ(all[0].distance_m, 7.02);
  EXPECT_EQ(all[0].status, 0xF00Fu);
  EXPECT_EQ(all[1].beam, 3);
  EXPECT_FALSE(all[1].velocity_mps || all[1].distance_m || all[1].figure_of_merit_mps);
  EXPECT_EQ(all[1].status, 0u);
}

TEST(Nortek, SpeedAndDirection) {
  const auto all = nortek_golden().all<NortekSpeed>();
  ASSERT_EQ(all.size(), 2u);
  for (const NortekSpeed& m : all) {
    EXPECT_EQ(m.speed_mps, 1.236);
    EXPECT_NEAR(degrees(*m.direction_rad), 357.4, 1e-9);
    EXPECT_EQ(m.distance_m, 7.02);
  }
}

TEST(Nortek, WaterTrackIsNotBottomTrack) {
  const auto velocity = nortek_golden().all<NortekWaterVelocity>();
  ASSERT_EQ(velocity.size(), 2u);
  for (const NortekWaterVelocity& m : velocity) {
    EXPECT_EQ(m.velocity_mps, (std::array<std::optional<double>, 3>{1.2345, -0.056, 0.078}));
    EXPECT_EQ(m.figure_of_merit_mps, 0.0031);
  }
  EXPECT_EQ(velocity[1].status, 0xF00Fu);
  const auto speed = nortek_golden().all<NortekWaterSpeed>();
  ASSERT_EQ(speed.size(), 1u);
  EXPECT_EQ(speed[0].speed_mps, 1.236);
}

TEST(Nortek, AWrittenSentenceReadsAsItWas) {
  auto m = nortek_golden().all<NortekVelocity>().at(1);
  std::array<std::uint8_t, 256> out;
  for (const bool with_state : {true, false}) {
    if (!with_state) m.status.reset();
    const std::size_t size = encode(m, out);
    const Bytes line{out.data(), size};
    EXPECT_EQ(Nortek::scan(line), Scan::frame(size));
    const auto read = std::get<NortekVelocity>(Nortek::decode(line).value());
    EXPECT_EQ(read.velocity_mps, m.velocity_mps);
    EXPECT_EQ(read.distance_m, m.distance_m);
    EXPECT_EQ(read.after_sentence_s, m.after_sentence_s);
    EXPECT_EQ(read.status, m.status);
    EXPECT_EQ(encode(m, std::span{out}.first(size - 1)), 0u);
  }
}

TEST(Nortek, WhatIsNotKnownIsWrittenAsAnEmptyField) {
  NortekVelocity m;
  m.status = 0;
  std::array<std::uint8_t, 256> out;
  const Bytes line{out.data(), encode(m, out)};
  EXPECT_TRUE(as_text(line).starts_with(
      "$PNORBT9,,,,-32.7680,-32.7680,-32.7680,10.0000,0.00,0.00,0.00,0.00,,,,,0x00000000*"));
  const auto read = std::get<NortekVelocity>(Nortek::decode(line).value());
  EXPECT_FALSE(read.ping_time_s || read.after_trigger_s || read.after_sentence_s);
  EXPECT_FALSE(read.battery_v || read.sound_speed_mps || read.temperature_k);
}

/// Sentences of pynmea2's tests. Columns: verdict on the checksum, sentence.
TEST(Nortek, SentencesOfAnotherProgramAreRead) {
  const auto file = corpora() / "dvl/nortek/pnor_sentences.txt";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no captures at " << corpora();
  const Buffer bytes = read_file(file);
  std::istringstream lines{std::string{as_text(bytes)}};
  std::size_t sentences = 0, messages = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("ok ")) continue;
    const auto reading = read_stream<Nortek>(as_bytes(line.substr(3) + "\r\n"));
    EXPECT_EQ(reading.frames.size(), 1u) << line;
    const bool bottom_track = line.find("$PNORBT") != line.npos;
    const bool water_track = line.find("$PNORWT") != line.npos;
    EXPECT_EQ(reading.messages.size(), bottom_track || water_track ? 1u : 0u) << line;
    EXPECT_EQ(reading.all<NortekWaterVelocity>().size() + reading.all<NortekWaterSpeed>().size(),
              water_track ? 1u : 0u);
    for (const auto& m : reading.all<NortekVelocity>()) {
      EXPECT_EQ(m.ping_time_s, 1452244916.7508);
      EXPECT_EQ(m.velocity_mps[2], 0.1234);
      EXPECT_EQ(m.distance_m[3], 23.45);
    }
    for (const auto& m : reading.all<NortekBeam>()) EXPECT_FALSE(m.velocity_mps);
    ++sentences;
    messages += reading.messages.size();
  }
  EXPECT_GT(sentences, messages);
  EXPECT_GT(messages, 0u);
}

}  // namespace nortek_test
}  // namespace drydock::wire::testing
