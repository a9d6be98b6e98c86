#include "drivers/wire/j1939/aceinna.hpp"

#include <gtest/gtest.h>

#include "drivers/wire/fields.hpp"
#include "tests/drivers/wire/can_fixture.hpp"

namespace drydock::wire::aceinna {
namespace aceinna_test {

using test::frame;
using test::only;
using test::text_of;

TEST(Aceinna, EncodesTheFramesOfARealSensor) {
  SlopeSensor slope{.source = 0x80,
                    .pitch_rad = radians(3.334197998046875),
                    .roll_rad = radians(-34.9815673828125),
                    .pitch_merit = FigureOfMerit::degraded,
                    .roll_merit = FigureOfMerit::degraded,
                    .latency_s = 0.003};
  EXPECT_EQ(text_of(encode(slope)), "0CF02980#C7AA7E5C826B4406");
  AngularRate rate{0x80, {radians(9.5703125), radians(-0.1640625), radians(-7.0546875)}, {}, 0.003};
  EXPECT_EQ(text_of(encode(rate)), "0CF02A80#C981EB7C79790006");
  Acceleration acceleration{0x80, {-9.75, 0.85, 0.1}, {}, 2};
  EXPECT_EQ(text_of(encode(acceleration)), "08F02D80#3179557D0A7D80FF");
}

TEST(Aceinna, AddressClaimHoldsTheNameInTheVendorsOrder) {
  AddressClaimed claim;
  claim.source = 0x81;
  claim.name = {180576, 823, 1, 20, 86, 120, 4, 0, true};
  EXPECT_EQ(text_of(encode(claim)), "18EEFF81#4178563437030B16");
}

TEST(Aceinna, EveryReservedRawValueIsEmpty) {
  // J1939-71: values from FB00h up are not measurements; FAFFh is the last measurement.
  for (unsigned raw = 0xFB00; raw <= 0xFFFF; ++raw) {
    CanFrame rates = frame("0CF02A80#0000000000000000");
    rates.data[0] = raw & 0xFF;
    rates.data[1] = raw >> 8;
    ASSERT_FALSE((only<AngularRate, Aceinna>({rates}).rate_radps[0])) << raw;
  }
  const auto last = only<AngularRate, Aceinna>({frame("0CF02A80#FFFA000000000000")});
  EXPECT_NEAR(degrees(*last.rate_radps[0]), 0xFAFF / 128.0 - 250, 1e-12);
  const auto slope = only<SlopeSensor, Aceinna>({frame("0CF02980#0000FBFFFFFA00FB")});
  EXPECT_FALSE(slope.pitch_rad);
  EXPECT_TRUE(slope.roll_rad);
  EXPECT_FALSE(slope.latency_s);
}

TEST(Aceinna, AValueMarkedErrorOrNotAvailableIsEmptyWhateverItsBits) {
  const auto m = only<Acceleration, Aceinna>({frame("08F02D80#007D007D007D3900")});
  EXPECT_TRUE(m.acceleration_mps2[0]);   // 1: degraded
  EXPECT_FALSE(m.acceleration_mps2[1]);  // 2: error
  EXPECT_FALSE(m.acceleration_mps2[2]);  // 3: not available
}

TEST(Aceinna, WhatDoesNotFitGoesOutAsErrorAndWhatIsMissingAsNotAvailable) {
  const AngularRate rate{0x80, {radians(300.0), std::nullopt, radians(-251.0)}, {}, std::nullopt};
  EXPECT_EQ(text_of(encode(rate)), "0CF02A80#00FEFFFF00FE00FF");
}

TEST(Aceinna, DecodesARealSensorAsAnIndependentDecoderDoes) {
  const auto frames = test::frames_of_log(test::corpus("can_imu/aceinna_mtlt_real.candump.log"));
  if (frames.empty()) GTEST_SKIP() << "corpora absent: can_imu";
  const auto expected = test::lines_of(test::corpus("can_imu/aceinna_mtlt_real.expected.jsonl"));
  ASSERT_EQ(frames.size(), expected.size());
  Aceinna::Decoder decoder;
  int seen = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const auto e = nlohmann::json::parse(expected[i]);
    const auto message = decoder.receive(frames[i]);
    if (e.contains("pitch_deg")) {
      const auto& m = std::get<SlopeSensor>(message.value());
      EXPECT_NEAR(degrees(*m.pitch_rad), e["pitch_deg"].get<double>(), 1e-9);
      EXPECT_NEAR(degrees(*m.roll_rad), e["roll_deg"].get<double>(), 1e-9);
      EXPECT_NEAR(*m.latency_s, e["latency_ms"].get<double>() * 1e-3, 1e-12);
    } else if (e.contains("rate_dps")) {
      const auto& m = std::get<AngularRate>(message.value());
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(degrees(*m.rate_radps[k]), e["rate_dps"][k].get<double>(), 1e-9);
      }
    } else if (e.contains("acc_ms2")) {
      const auto& m = std::get<Acceleration>(message.value());
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(*m.acceleration_mps2[k], e["acc_ms2"][k].get<double>(), 1e-9);
      }
    } else {
      EXPECT_EQ(message.has_value(),
                e["pgn"] == j1939::request_pgn || e["pgn"] == software_bit_pgn);
      continue;
    }
    ++seen;
  }
  EXPECT_EQ(seen, 14);
  EXPECT_EQ(decoder.counters().frames, 20u);
  EXPECT_EQ(decoder.counters().bad_checksums, 0u);
}

}  // namespace aceinna_test
}  // namespace drydock::wire::aceinna
