#include "drivers/wire/dvl/nortek_ad2cp.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "drivers/wire/bytes.hpp"
#include "hil/emulate/dvl/ad2cp_axes.hpp"
#include "hil/emulate/dvl/ad2cp_dialogue.hpp"
#include "tests/hil/emulate/bench.hpp"

namespace drydock::emulate {
namespace nortek_ad2cp_test {

using rig_config::DeviceKind;
using wire::ad2cp::Estimates;
using wire::ad2cp::Four;

float float_at(const Recorder::Message& record, std::size_t offset) {
  return wire::load_le<float>(record.bytes, 10 + offset);
}

rig_config::DeviceConfig dvl(double rate_hz = 1) {
  auto config = device(DeviceKind::dvl, "nortek-ad2cp", rate_hz);
  config.emulate.latency_s = 0.125;
  return config;
}

motion::Truth level() {
  motion::Truth truth = under_way();
  truth.body_to_ned.setIdentity();
  return truth;
}

/// Offsets of the DVL manual, from the first byte of the data.
TEST(EmulatedNortekAd2cp, TheRecordHoldsTheTruthWhereTheManualSays) {
  const Frozen trajectory(level());
  const auto sent = record(dvl(), trajectory, 0.2);
  ASSERT_EQ(sent.messages.size(), 1u);
  const auto& r = sent.messages[0];
  ASSERT_EQ(r.bytes.size(), 222u);
  EXPECT_EQ(wire::NortekAd2cp::scan(r.bytes), wire::Scan::frame(222));
  EXPECT_EQ(r.bytes[2], 0x1B);
  EXPECT_EQ(r.bytes[3], 0x10);
  // 22:13:20 less 0.0636 s from the trigger to the echo of 30 m: 0.0084 + 0.00184 x 30.
  EXPECT_EQ(r.bytes[16], 123);  // 2023
  EXPECT_EQ(r.bytes[17], 10);   // November
  EXPECT_EQ(r.bytes[20], 13);
  EXPECT_EQ(r.bytes[21], 19);
  EXPECT_EQ(wire::load_le<std::uint16_t>(r.bytes, 22), 9364);
  EXPECT_EQ(wire::load_le<std::uint32_t>(r.bytes, 30), 0x100FFFFFu);
  for (std::size_t beam = 0; beam < 4; ++beam) {
    EXPECT_NEAR(float_at(r, 52 + 4 * beam), 30, 1e-5);
    EXPECT_NEAR(float_at(r, 84 + 4 * beam), 0.0636, 1e-6);
    EXPECT_NEAR(float_at(r, 100 + 4 * beam), -0.125, 1e-6);
  }
  EXPECT_NEAR(float_at(r, 132), 2, 1e-6);
  EXPECT_NEAR(float_at(r, 136), 0.123, 1e-6);
  EXPECT_NEAR(float_at(r, 140), -0.045, 1e-6);
  EXPECT_NEAR(float_at(r, 144), -0.045, 1e-6);
  EXPECT_EQ(float_at(r, 180), -0.125F);
}

/// The factors were measured in the records of a DVL333.
TEST(EmulatedNortekAd2cp, TheAxesFollowFromTheBeamsAsInRealRecords) {
  const Frozen trajectory(level());
  auto config = dvl();
  config.emulate.head.beam_noise_mps = 0.05;
  const auto sent = record(config, trajectory, 0.2);
  const auto& r = sent.messages.at(0);
  const auto beam = [&](std::size_t i) { return float_at(r, 36 + 4 * i); };
  constexpr double k = 0.83976, z = 0.55124;
  EXPECT_NEAR(float_at(r, 132), k * (beam(0) + beam(1) - beam(2) - beam(3)), 2e-5);
  EXPECT_NEAR(float_at(r, 136), k * (beam(0) - beam(1) - beam(2) + beam(3)), 2e-5);
  EXPECT_NEAR(float_at(r, 140), z * (beam(0) + beam(2)), 2e-5);
  EXPECT_NEAR(float_at(r, 144), z * (beam(1) + beam(3)), 2e-5);
  EXPECT_NEAR(float_at(r, 148), k * 2 * 0.05, 2e-5);
  EXPECT_NEAR(float_at(r, 156), z * std::numbers::sqrt2 * 0.05, 2e-5);
  EXPECT_NE(float_at(r, 140), float_at(r, 144)) << "the noise of the beams is their own";
}

/// A record of a DVL333 without beam 1.
TEST(EmulatedNortekAd2cp, WithoutOneBeamTheAxesAreThoseOfARealDvl) {
  Estimates beams, axes;
  beams.velocity_mps = {std::nullopt, 0.18517034, -0.21602023, -0.22386393};
  beams.figure_of_merit_mps = {std::nullopt, 0.0011453646, 0.0029304945, 0.0031901686};
  set_axes(beams, ad2cp_beam_angle_rad, axes);
  EXPECT_NEAR(*axes.velocity_mps[0], 0.67381215, 1e-5);
  EXPECT_NEAR(*axes.velocity_mps[1], -0.013179064, 1e-5);
  EXPECT_NEAR(*axes.velocity_mps[2], -0.021329202, 1e-5);
  EXPECT_FALSE(axes.velocity_mps[3] || axes.figure_of_merit_mps[3]);
  EXPECT_NEAR(*axes.figure_of_merit_mps[0], 0.005284391, 1e-7);
  EXPECT_NEAR(*axes.figure_of_merit_mps[1], 0.007275451, 1e-7);
  EXPECT_NEAR(*axes.figure_of_merit_mps[2], 0.0018684347, 1e-7);
}

TEST(EmulatedNortekAd2cp, WithTwoBeamsOrFewerThereAreNoAxes) {
  Estimates beams, axes;
  beams.velocity_mps = {std::nullopt, 0.18, -0.21, std::nullopt};
  beams.figure_of_merit_mps = {std::nullopt, 0.001, 0.003, std::nullopt};
  set_axes(beams, ad2cp_beam_angle_rad, axes);
  EXPECT_EQ(axes.velocity_mps, Four{});
}

TEST(EmulatedNortekAd2cp, BeyondItsRangeTheRecordHasTheMarksOfMissingValues) {
  motion::Truth truth = under_way();
  truth.bed_depth_m = 400;
  const Frozen trajectory(truth);
  const auto sent = record(dvl(), trajectory, 0.2);
  const auto& r = sent.messages.at(0);
  EXPECT_EQ(wire::load_le<std::uint32_t>(r.bytes, 30), 0x10000000u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(float_at(r, 36 + 4 * i), -32.768F);
    EXPECT_EQ(float_at(r, 52 + 4 * i), 0.0F);
    EXPECT_EQ(float_at(r, 68 + 4 * i), 10.0F);
    EXPECT_EQ(float_at(r, 132 + 4 * i), -32.768F);
    EXPECT_EQ(float_at(r, 148 + 4 * i), 10.0F);
  }
}

TEST(EmulatedNortekAd2cp, WithAWaterLayerASecondRecordIsItsWaterTrack) {
  motion::Truth truth = level();
  truth.current_ned = {0.5, 0, 0};
  const Frozen trajectory(truth);
  auto config = dvl();
  config.emulate.head.layer_start_m = 2;
  config.emulate.head.layer_thickness_m = 4;
  const auto sent = record(config, trajectory, 0.2);
  ASSERT_EQ(sent.messages.size(), 2u);
  const auto& water = sent.messages[1];
  EXPECT_EQ(water.bytes[2], 0x1D);
  EXPECT_NEAR(float_at(water, 132), 1.5, 1e-6);
  EXPECT_NEAR(float_at(water, 52), 4, 1e-6);
}

TEST(EmulatedNortekAd2cp, ADataPortOfTcpBeginsWithItsBanner) {
  const Frozen trajectory(level());
  auto config = dvl();
  config.link = "tcp:127.0.0.1:9002";
  const auto sent = record(config, trajectory, 1.2);
  ASSERT_EQ(sent.messages.size(), 3u);
  EXPECT_EQ(text(sent.messages[0]), "\r\nNortek DVL1000 Data Interface\r\n");
  EXPECT_EQ(sent.messages[1].bytes.size(), 222u);
}

class Ad2cpDialogueTest : public testing::Test {
 protected:
  std::string answer_to(std::string_view said, bool refuses = false) {
    return dialogue_.receive({reinterpret_cast<const std::uint8_t*>(said.data()), said.size()},
                             refuses);
  }
  Ad2cpDialogue dialogue_;
};

TEST_F(Ad2cpDialogueTest, ABreakEndsTheMeasurementAndStartBeginsItAgain) {
  EXPECT_TRUE(dialogue_.measures());
  EXPECT_EQ(answer_to("K1W%!Q"), "OK\r\n");
  EXPECT_FALSE(dialogue_.measures());
  EXPECT_EQ(answer_to("START\r\n"), "OK\r\n");
  EXPECT_TRUE(dialogue_.measures());
  EXPECT_EQ(answer_to("\x03"), "OK\r\n");
  EXPECT_FALSE(dialogue_.measures());
}

TEST_F(Ad2cpDialogueTest, WhileItMeasuresItMustBeWokenForEachLineAndTakesNoSettings) {
  EXPECT_EQ(answer_to("GETBT,DF\r\n"), "ERROR\r\n");
  EXPECT_EQ(answer_to("BBPWAKEUP\r\nGETBT,DF\r\n"), "OK\r\n21\r\nOK\r\n");
  EXPECT_EQ(answer_to("BBPWAKEUP\r\nSETBT,DF=22\r\n"), "OK\r\nERROR\r\n");
  EXPECT_EQ(answer_to("BBPWAKEUP\r\nSTOP\r\n"), "OK\r\nOK\r\n");
  EXPECT_EQ(answer_to("SETBT,DF=22\r\nGETBT,DF\r\n"), "OK\r\n22\r\nOK\r\n");
}

TEST_F(Ad2cpDialogueTest, SettingsAreTakenAllOrNothingAndReadBackInTheManualsOrder) {
  answer_to("K1W%!Q");
  EXPECT_EQ(answer_to("SETBT,RANGE=30.5,DF=22\r\n"), "OK\r\n");
  EXPECT_EQ(answer_to("GETBT\r\n"), "30.50,5.00,4,1234,22,0.0\r\nOK\r\n");
  EXPECT_EQ(answer_to("SETBT,RANGE=20,DF=99\r\n"), "ERROR\r\n");
  EXPECT_EQ(answer_to("GETERROR\r\n"), "\"DF must be 21 to 22\"\r\nOK\r\n");
  EXPECT_EQ(answer_to("GETBT,RANGE\r\n"), "30.50\r\nOK\r\n");
  EXPECT_EQ(dialogue_.range_m(), 30.5);
  EXPECT_EQ(answer_to("SETTMBT,EN=1,SO=0\r\nGETTMBT,SO\r\nSAVE\r\n"), "OK\r\n0\r\nOK\r\nOK\r\n");
  EXPECT_FALSE(dialogue_.puts_out());
}

TEST_F(Ad2cpDialogueTest, WhatItDoesNotKnowIsAnError) {
  answer_to("\x03");
  for (const char* line : {"HELLO\r\n", "SETBT\r\n", "SETBT,COLOUR=3\r\n", "SETBT,RANGE\r\n",
                           "SETBT,RANGE=far\r\n", "GETBT,COLOUR\r\n"})
    EXPECT_EQ(answer_to(line), "ERROR\r\n") << line;
  EXPECT_EQ(answer_to(std::string(600, 'x') + "\r\n"), "ERROR\r\n");
  EXPECT_EQ(answer_to("\r\n\r\n"), "");
}

TEST_F(Ad2cpDialogueTest, ADvlThatRefusesAnswersErrorAndKeepsItsSettings) {
  answer_to("K1W%!Q");
  EXPECT_EQ(answer_to("SETBT,DF=22\r\n", true), "ERROR\r\n");
  EXPECT_EQ(answer_to("START\r\n", true), "ERROR\r\n");
  EXPECT_EQ(answer_to("GETBT,DF\r\n", true), "21\r\nOK\r\n");
}

TEST(EmulatedNortekAd2cp, ObeysItsCommands) {
  const Frozen trajectory(level());
  const auto made = make_emulated_device(dvl(5), trajectory, 1).value();
  Recorder recorder;
  const auto say = [&](std::string_view said) {
    recorder.messages.clear();
    made->receive({reinterpret_cast<const std::uint8_t*>(said.data()), said.size()}, recorder.now,
                  recorder);
    return recorder.messages.empty() ? "" : text(recorder.messages.front());
  };
  EXPECT_EQ(say("K1W%!Q"), "OK\r\n");
  recorder.run(*made, at_s(1));
  EXPECT_EQ(recorder.messages.size(), 1u) << "only the answer";
  EXPECT_EQ(say("SETBT,RANGE=20\r\nSTART\r\n"), "OK\r\nOK\r\n");
  recorder.messages.clear();
  recorder.run(*made, at_s(2));
  ASSERT_EQ(recorder.messages.size(), 5u);
  EXPECT_EQ(float_at(recorder.messages[0], 52), 0.0F) << "the bed at 30 m is out of range";
}

/// Offsets of the Signature Integrator's Guide.
TEST(EmulatedNortekAd2cp, WithTheSignOfItsVelocityItIsASignature) {
  const Frozen trajectory(level());
  for (const bool of_bed : {false, true}) {
    auto config = dvl();
    config.velocity_of_bed = of_bed;
    const auto sent = record(config, trajectory, 0.2);
    ASSERT_EQ(sent.messages.size(), 1u);
    const auto& r = sent.messages[0];
    ASSERT_EQ(wire::NortekAd2cp::scan(r.bytes), wire::Scan::frame(120));
    EXPECT_EQ(r.bytes[2], 0x17);
    EXPECT_EQ(wire::load_le<std::uint16_t>(r.bytes, 10 + 30), 4 << 12 | 1 << 10) << "X, Y, Z";
    EXPECT_EQ(wire::load_le<std::int32_t>(r.bytes, 10 + 78), of_bed ? -20000 : 20000);
    EXPECT_EQ(wire::load_le<std::int32_t>(r.bytes, 10 + 82), of_bed ? -1230 : 1230);
    EXPECT_EQ(wire::load_le<std::int32_t>(r.bytes, 10 + 94), 30000) << "mm";
  }
}

}  // namespace nortek_ad2cp_test
}  // namespace drydock::emulate
