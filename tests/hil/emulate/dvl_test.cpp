#include <gtest/gtest.h>

#include <cmath>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/dvl/pd0.hpp"
#include "tests/hil/emulate/bench.hpp"

namespace drydock::emulate {
namespace {

using rig_config::DeviceKind;
using wire::load_le;

wire::Pd0Ensemble decoded(const Recorder::Message& message) {
  EXPECT_EQ(wire::Pd0::scan(message.bytes), wire::Scan::frame(message.bytes.size()));
  return std::get<wire::Pd0Ensemble>(wire::Pd0::decode(message.bytes).value());
}

// Finds the data type with this id by the table in the ensemble.
wire::Bytes data_type(wire::Bytes ensemble, std::uint16_t id) {
  for (std::size_t i = 0; i < ensemble[5]; ++i) {
    const auto offset = load_le<std::uint16_t>(ensemble, 6 + 2 * i);
    if (load_le<std::uint16_t>(ensemble, offset) == id) return ensemble.subspan(offset);
  }
  return {};
}

TEST(EmulatedDvl, TheEnsembleHoldsTheTruthWithinTheProtocolsResolution) {
  const Frozen trajectory(under_way());
  const auto sent = record(device(DeviceKind::dvl, "pd0", 2), trajectory, 1.2);
  ASSERT_EQ(sent.messages.size(), 3);
  const auto ensemble = decoded(sent.messages[2]);
  EXPECT_EQ(ensemble.fixed.frame, wire::DvlFrame::ship);
  EXPECT_FALSE(ensemble.fixed.tilts_used);
  EXPECT_NEAR(*ensemble.fixed.beam_angle_rad, 30 * degree, 1e-9);
  EXPECT_EQ(ensemble.variable.ensemble, 3);
  EXPECT_EQ(ensemble.variable.clock->time_since_epoch(), std::chrono::milliseconds{1700000001000});
  EXPECT_NEAR(*ensemble.variable.heading_rad, 290 * degree, 1e-4);
  EXPECT_NEAR(*ensemble.variable.roll_rad, 3 * degree, 1e-4);
  EXPECT_NEAR(std::tan(*ensemble.variable.pitch_rad), std::tan(-4 * degree) / std::cos(3 * degree),
              1e-4);
  EXPECT_NEAR(ensemble.variable.depth_m, 20, 0.05);
  EXPECT_NEAR(*ensemble.variable.temperature_k, 283.15, 0.005);
  const auto& track = *ensemble.bottom_track;
  EXPECT_NEAR(*track.velocity_mps[0], 0.123, 5e-4);  // starboard
  EXPECT_NEAR(*track.velocity_mps[1], 2.000, 5e-4);  // forward
  EXPECT_NEAR(*track.velocity_mps[2], 0.045, 5e-4);  // mast
  EXPECT_NEAR(*track.velocity_mps[3], 0, 5e-4);
}

TEST(EmulatedDvl, OnTheWireTheBedMovesNotTheVehicle) {
  const Frozen trajectory(under_way());
  const auto sent = record(device(DeviceKind::dvl, "pd0"), trajectory, 0);
  const auto track = data_type(sent.messages.at(0).bytes, 0x0600);
  // Table 40 of the Pathfinder guide: ship starboard, forward, mast in mm/s at 24, 26, 28.
  EXPECT_EQ(load_le<std::int16_t>(track, 24), -123);
  EXPECT_EQ(load_le<std::int16_t>(track, 26), -2000);
  EXPECT_EQ(load_le<std::int16_t>(track, 28), -45);
}

TEST(EmulatedDvl, RangesComeFromTheHeadsPlaceAndAttitudeOverTheBed) {
  motion::Truth truth = under_way();
  truth.body_to_ned.setIdentity();
  const Frozen trajectory(truth);
  auto config = device(DeviceKind::dvl, "pd0");
  config.lever_arm_m = {0, 0, 0.5};
  const auto sent = record(config, trajectory, 0);
  const auto track = data_type(sent.messages.at(0).bytes, 0x0600);
  for (std::size_t beam = 0; beam < 4; ++beam) {
    EXPECT_EQ(load_le<std::uint16_t>(track, 16 + 2 * beam), 2950);  // cm
  }
}

TEST(EmulatedDvl, TheHeadsVelocityIsThatOfItsLeverArmInItsTurnedAxes) {
  motion::Truth truth = under_way();
  truth.velocity_body = {2, 0, 0};
  truth.rate_body = {0, 0, 0.1};
  const Frozen trajectory(truth);
  auto config = device(DeviceKind::dvl, "pd0");
  config.lever_arm_m = {5, 0, 0};
  config.mounting_rad = {0, 0, 90 * degree};
  const auto ensemble = decoded(record(config, trajectory, 0).messages.at(0));
  // v + w x r = (2, 0.5, 0). The head's x points to starboard, its y astern.
  EXPECT_NEAR(*ensemble.bottom_track->velocity_mps[1], 0.5, 5e-4);
  EXPECT_NEAR(*ensemble.bottom_track->velocity_mps[0], -2, 5e-4);
}

TEST(EmulatedDvl, BeyondItsRangeItSaysThatEveryVelocityIsBad) {
  motion::Truth truth = under_way();
  truth.bed_depth_m = 400;
  const Frozen trajectory(truth);
  const auto sent = record(device(DeviceKind::dvl, "pd0"), trajectory, 0);
  const auto track = data_type(sent.messages.at(0).bytes, 0x0600);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(load_le<std::int16_t>(track, 24 + 2 * i), -32768);
    EXPECT_EQ(load_le<std::uint16_t>(track, 16 + 2 * i), 0);
  }
}

TEST(EmulatedDvl, InPd4AndPd5TheVehicleMoves) {
  const Frozen trajectory(under_way());
  for (const auto& [protocol, size] : {std::pair{"pd4", 47U}, {"pd5", 88U}}) {
    const auto sent = record(device(DeviceKind::dvl, protocol), trajectory, 0);
    const wire::Bytes report = sent.messages.at(0).bytes;
    ASSERT_EQ(report.size(), size);
    // Table 48 of the Pathfinder guide, bytes 5 to 13: ship axes, three beams suffice, 600 kHz;
    // starboard, forward, mast.
    EXPECT_EQ(report[4], 0b1001'0011);
    EXPECT_EQ(load_le<std::int16_t>(report, 5), 123);
    EXPECT_EQ(load_le<std::int16_t>(report, 7), 2000);
    EXPECT_EQ(load_le<std::int16_t>(report, 9), 45);
    EXPECT_EQ(report[35], 22);  // 22:13:20 UTC
    EXPECT_EQ(report[36], 13);
    EXPECT_EQ(report[37], 20);
  }
}

TEST(EmulatedDvl, AWaterLinkedPd4HasThatMakersAxesAndConfiguration) {
  const Frozen trajectory(under_way());
  auto config = device(DeviceKind::dvl, "pd4");
  config.maker = rig_config::DvlMaker::water_linked;
  const auto sent = record(config, trajectory, 0);
  const wire::Bytes report = sent.messages.at(0).bytes;
  EXPECT_EQ(report[4], 0b1010'0011);  // from the maker's documentation
  EXPECT_EQ(load_le<std::int16_t>(report, 5), 2000);
  EXPECT_EQ(load_le<std::int16_t>(report, 7), 123);
  EXPECT_EQ(load_le<std::int16_t>(report, 9), -45);
}

TEST(EmulatedDvl, APd6EnsembleIsTenLines) {
  motion::Truth truth = under_way();
  truth.body_to_ned.setIdentity();
  truth.roll_rad = truth.pitch_rad = truth.yaw_rad = 0;
  truth.velocity_body.z() = -0.046;
  const Frozen trajectory(truth);
  const auto sent = record(device(DeviceKind::dvl, "pd6"), trajectory, 0);
  EXPECT_EQ(text(sent.messages.at(0)),
            ":SA, +0.00, +0.00,  0.00\r\n"
            ":TS,23111422132000,35.0,+10.0,  20.0,1490.3,  0\r\n"
            ":WI,-32768,-32768,-32768,-32768,V\r\n"
            ":WS,-32768,-32768,-32768,V\r\n"
            ":WE,-32768,-32768,-32768,V\r\n"
            ":WD,       +0.00,       +0.00,       +0.00,   0.00,  0.00\r\n"
            ":BI,  +123, +2000,   +46,    +0,A\r\n"
            ":BS,  +123, +2000,   +46,A\r\n"
            ":BE,  +123, +2000,   +46,A\r\n"
            ":BD,       +0.12,       +2.00,       +0.05,  30.00,  0.00\r\n");
}

/// Level in a current of 0.5 m/s to the north, with a water layer from 2 to 6 m.
Recorder with_water_layer(std::string protocol, motion::Truth truth = under_way()) {
  truth.body_to_ned.setIdentity();
  truth.current_ned = {0.5, 0, 0};
  const Frozen trajectory(truth);
  auto config = device(DeviceKind::dvl, std::move(protocol));
  config.emulate.head.layer_start_m = 2;
  config.emulate.head.layer_thickness_m = 4;
  return record(config, trajectory, 0);
}

TEST(EmulatedDvl, InPd0TheWaterLayerStandsInTheBottomTrack) {
  const auto sent = with_water_layer("pd0");
  const auto track = data_type(sent.messages.at(0).bytes, 0x0600);
  // Table 40 of the Pathfinder guide: near and far in dm at 46 and 48, velocities at 50, per cent
  // good at 66.
  EXPECT_EQ(load_le<std::uint16_t>(track, 46), 20);
  EXPECT_EQ(load_le<std::uint16_t>(track, 48), 60);
  EXPECT_EQ(load_le<std::int16_t>(track, 50), -123);
  EXPECT_EQ(load_le<std::int16_t>(track, 52), -1500);
  EXPECT_EQ(load_le<std::int16_t>(track, 54), -45);
  EXPECT_EQ(track[66], 100);
  const auto ensemble = decoded(sent.messages.at(0));
  EXPECT_NEAR(*ensemble.bottom_track->water_velocity_mps[1], 1.5, 5e-4);
  EXPECT_NEAR(*ensemble.bottom_track->layer_far_m, 6, 1e-9);
}

TEST(EmulatedDvl, InPd4TheWaterLayerHasItsOwnVelocityAndStatus) {
  const auto sent = with_water_layer("pd4");
  const wire::Bytes report = sent.messages.at(0).bytes;
  EXPECT_EQ(load_le<std::int16_t>(report, 22), 123);
  EXPECT_EQ(load_le<std::int16_t>(report, 24), 1500);
  EXPECT_EQ(load_le<std::int16_t>(report, 26), 45);
  EXPECT_EQ(load_le<std::uint16_t>(report, 30), 20);
  EXPECT_EQ(load_le<std::uint16_t>(report, 32), 60);
  EXPECT_EQ(report[34], 0);
}

TEST(EmulatedDvl, InPd6TheWaterLinesAreGoodWhileTheLayerIsClearOfTheBed) {
  EXPECT_NE(text(with_water_layer("pd6").messages.at(0)).find(":WI,  +123, +1500,   +45,    +0,A"),
            std::string::npos);
  motion::Truth truth = under_way();
  truth.bed_depth_m = 25;  // 5 m under the head
  const std::string lost = text(with_water_layer("pd6", truth).messages.at(0));
  EXPECT_NE(lost.find(":WI,-32768,-32768,-32768,-32768,V"), std::string::npos);
  EXPECT_NE(lost.find(":BI,  +123, +2000,   +45,    +0,A"), std::string::npos);
}

TEST(EmulatedDvl, NortekSendsASecondSentenceForTheWater) {
  const auto sent = with_water_layer("nortek");
  ASSERT_EQ(sent.messages.size(), 2);
  EXPECT_EQ(text(sent.messages[0]).substr(0, 9), "$PNORBT9,");
  EXPECT_EQ(text(sent.messages[1]).substr(0, 9), "$PNORWT9,");
  EXPECT_NE(text(sent.messages[1]).find(",1.5000,0.1230,-0.0450,"), std::string::npos);
}

TEST(EmulatedDvl, EchoesFadeTowardsTheLongestRange) {
  motion::Truth truth = under_way();
  truth.body_to_ned.setIdentity();
  truth.bed_depth_m = 20 + 120 * std::cos(30 * degree);  // exactly at the limit
  auto config = device(DeviceKind::dvl, "pd0", 10);
  const Frozen at_the_limit(truth);
  int locked = 0;
  for (const auto& message : record(config, at_the_limit, 100).messages) {
    const auto track = *decoded(message).bottom_track;
    for (std::size_t i = 0; i < 4; ++i) {
      // At least 8 dB: 255 x / (1 + x) with x = 6.3.
      if (track.range_m[i]) {
        EXPECT_GE(track.correlation[i], 220);
      }
    }
    locked += track.velocity_mps[0].has_value();
  }
  // Each beam is found in half of the pings. Three or four beams are found in 5 of 16 pings.
  EXPECT_NEAR(locked / 1001.0, 5 / 16.0, 0.05);
  truth.bed_depth_m = 30;
  const Frozen near(truth);
  EXPECT_GE(decoded(record(config, near, 0).messages.at(0)).bottom_track->correlation[0], 254);
}

TEST(EmulatedDvl, BeamNoiseShowsInTheErrorVelocity) {
  const Frozen trajectory(under_way());
  auto config = device(DeviceKind::dvl, "pd0", 10);
  config.emulate.head.beam_noise_mps = 0.02;
  double across = 0, error = 0;
  const auto sent = record(config, trajectory, 200);
  for (const auto& message : sent.messages) {
    const auto v = decoded(message).bottom_track->velocity_mps;
    across += std::pow(*v[0] - 0.123, 2);
    error += std::pow(*v[3], 2);
  }
  const auto sigma = [&](double sum) {
    return std::sqrt(sum / static_cast<double>(sent.messages.size()));
  };
  const double four_sigma = 4 * 0.0283 / std::sqrt(2.0 * 2001);
  // Both are differences with the same scale: sigma / (sqrt2 sin 30 deg).
  EXPECT_NEAR(sigma(across), 0.02 * std::numbers::sqrt2, four_sigma);
  EXPECT_NEAR(sigma(error), 0.02 * std::numbers::sqrt2, four_sigma);
}

}  // namespace
}  // namespace drydock::emulate
