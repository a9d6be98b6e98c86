#include "hil/sensor/dvl.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "estimators/frame/attitude.hpp"
#include "tests/hil/frozen.hpp"

namespace drydock::sensor {
namespace dvl_test {

using Eigen::Vector3d;
using motion::Truth;
using motion::test::Frozen;
using rig_config::BedKind;
using rig_config::OceanConfig;

constexpr double degree = std::numbers::pi / 180;
const double c30 = std::cos(30 * degree);

Truth level(double depth = 10, double bed = 60) {
  Truth truth;
  truth.latitude_rad = 45 * degree;
  truth.height_m = -depth;
  truth.bed_depth_m = bed;
  truth.velocity_body = truth.velocity_ned = {2, 0.3, -0.1};
  return truth;
}

Truth tilted(Truth truth, double roll_deg, double pitch_deg, double yaw_deg = 0) {
  truth.body_to_ned = frame::body_to_ned({roll_deg * degree, pitch_deg * degree, yaw_deg * degree});
  truth.velocity_ned = truth.body_to_ned * truth.velocity_body;
  return truth;
}

/// A bed that descends by 20 degrees to the north and is 60 m deep at the vehicle.
OceanConfig slope() {
  OceanConfig ocean;
  ocean.bed = {
      .kind = BedKind::slope, .depth_m = 60, .gradient = std::tan(20 * degree), .file = {}};
  return ocean;
}

DvlPing ping(const Truth& truth, const JanusHead& head = {}, const PingNoise& noise = {}) {
  return dvl_ping(Frozen(truth), {}, {}, head, noise);
}

TEST(DvlPing, LevelOverAPlaneAllBeamsReadTheAltitudesVerticalRange) {
  const auto sample = ping(level());
  ASSERT_TRUE(sample.velocity && sample.altitude_m && sample.error_velocity_mps);
  EXPECT_NEAR((*sample.velocity - Vector3d(2, 0.3, -0.1)).norm(), 0, 1e-12);
  EXPECT_NEAR(*sample.error_velocity_mps, 0, 1e-12);
  EXPECT_NEAR(*sample.altitude_m, 50, 1e-9);
  for (const auto& range : sample.range_m) EXPECT_NEAR(*range, 50, 1e-9);
}

TEST(DvlPing, AHeadThatIsSetToAWrongSpeedOfSoundReadsAllInThatProportion) {
  const auto sound = ping(level());
  const auto wrong = ping(level(), {.set_sound_speed_mps = 1.02 * sound.sound_speed});
  EXPECT_NEAR((*wrong.velocity - 1.02 * Vector3d(2, 0.3, -0.1)).norm(), 0, 1e-12);
  EXPECT_NEAR(*wrong.altitude_m, 51, 1e-9);
  EXPECT_NEAR(*wrong.range_m[2], 51, 1e-9);
  EXPECT_EQ(wrong.sound_speed, 1.02 * sound.sound_speed) << "and tells the speed that it used";
}

TEST(DvlPing, NosedUpTheForwardBeamIsTheLongestAndTheAfterBeamTheShortest) {
  const auto sample = ping(tilted(level(), 0, 10));
  // Beams 3 and 4 are 30 deg before and behind the axis, which points 10 deg forward.
  EXPECT_NEAR(*sample.range_m[2], 50 / std::cos(40 * degree) * c30, 1e-9);
  EXPECT_NEAR(*sample.range_m[3], 50 / std::cos(20 * degree) * c30, 1e-9);
  EXPECT_NEAR(*sample.range_m[0], 50 / (c30 * std::cos(10 * degree)) * c30, 1e-9);
  EXPECT_NEAR(*sample.range_m[1], *sample.range_m[0], 1e-9);
  EXPECT_NEAR(*sample.altitude_m, 50, 1e-9);
}

TEST(DvlPing, HeeledToStarboardTheStarboardBeamIsTheShortest) {
  const auto sample = ping(tilted(level(), 5, 0));
  // PD0: beam 1 points to port, beam 2 to starboard.
  EXPECT_NEAR(*sample.range_m[1], 50 / std::cos(25 * degree) * c30, 1e-9);
  EXPECT_NEAR(*sample.range_m[0], 50 / std::cos(35 * degree) * c30, 1e-9);
}

TEST(DvlPing, OverASlopeTheDownhillBeamIsTheLongestAndTheAltitudeStaysTheHeads) {
  const auto sample = dvl_ping(Frozen(level(), slope()), {}, {}, {});
  // Sine rule. The heading is north, so beam 3 points downhill.
  EXPECT_NEAR(*sample.beams[2].range_m, 50 * std::cos(20 * degree) / std::cos(50 * degree), 1e-6);
  EXPECT_NEAR(*sample.beams[3].range_m, 50 * std::cos(20 * degree) / std::cos(10 * degree), 1e-6);
  EXPECT_NEAR(*sample.beams[0].range_m, 50 / c30, 1e-6);
  // Each pair's harmonic mean gives the distance to the plane along the head's axis, here the plumb
  // line.
  EXPECT_NEAR(*sample.altitude_m, 50, 1e-6);
  EXPECT_NEAR((*sample.velocity - Vector3d(2, 0.3, -0.1)).norm(), 0, 1e-12);
}

TEST(DvlPing, NosedDownSlopeParallelToTheBedAllBeamsReadAlike) {
  // The axis is perpendicular to the bed at a distance of 50 cos 20. The head reports this times
  // cos 20.
  const auto sample = dvl_ping(Frozen(tilted(level(), 0, -20), slope()), {}, {}, {});
  for (const auto& range : sample.range_m) EXPECT_NEAR(*range, 50 * std::cos(20 * degree), 1e-6);
  EXPECT_NEAR(*sample.altitude_m, 50 * std::pow(std::cos(20 * degree), 2), 1e-6);
}

TEST(DvlPing, AMountedHeadSeesTheSlopeFromItsOwnPlaceAndBeams) {
  // Turned by 90 deg to starboard, 6 m ahead: beam 1 (port) now points north, downhill.
  rig_config::DeviceConfig config;
  config.mounting_rad = {0, 0, 90 * degree};
  config.lever_arm_m = {6, 0, 0};
  const auto sample = dvl_ping(Frozen(level(), slope()), {}, mounting_of(config), {});
  const double under = 50 + 6 * std::tan(20 * degree);
  EXPECT_NEAR(*sample.beams[0].range_m, under * std::cos(20 * degree) / std::cos(50 * degree),
              1e-4);
  EXPECT_NEAR(*sample.beams[2].range_m, under / c30, 1e-4);
}

TEST(DvlPing, LosesTheBedAtItsLongestAndItsShortestRange) {
  // When level, the range is altitude / cos 30 deg: a range of 120 m is an altitude of 103.92 m.
  EXPECT_TRUE(ping(level(10, 10 + 103.9)).velocity);
  const auto lost = ping(level(10, 10 + 104));
  EXPECT_FALSE(lost.velocity || lost.altitude_m || lost.range_m[0] || lost.error_velocity_mps);
  EXPECT_TRUE(ping(level(10, 10.27)).velocity);
  EXPECT_FALSE(ping(level(10, 10.25)).velocity);
  EXPECT_FALSE(ping(level(10, 9)).velocity);  // in the bed
}

TEST(DvlPing, EchoesWeakenWithSpreadingAndAbsorptionToTheThreshold) {
  const auto snr = [](double range) { return ping(level(10, 10 + range * c30)).beams[0].snr_db; };
  EXPECT_NEAR(snr(119.9999), detection_snr_db, 1e-3);
  EXPECT_NEAR(snr(60) - snr(119.9999), 20 * std::log10(2) + 2 * 0.16 * 60, 1e-3);
}

TEST(DvlPing, AFadedEchoIsLostAndAStrongOneCarriesBeyondTheRange) {
  PingNoise noise;
  noise.fade_db = {-5, 0, 0, 5};
  const auto near = ping(level(10, 10 + 119 * c30), {}, noise);
  EXPECT_FALSE(near.beams[0].range_m);
  EXPECT_TRUE(near.beams[1].range_m);
  const auto far = ping(level(10, 10 + 121 * c30), {}, noise);
  EXPECT_FALSE(far.beams[1].range_m);
  EXPECT_TRUE(far.beams[3].range_m);
}

TEST(DvlPing, ThreeBeamsGiveAVelocityWithoutAnErrorVelocity) {
  PingNoise noise;
  for (std::size_t lost = 0; lost < 4; ++lost) {
    noise.fade_db = {};
    noise.fade_db[lost] = -100;
    const auto three = ping(level(), {}, noise);
    ASSERT_TRUE(three.velocity);
    EXPECT_NEAR((*three.velocity - Vector3d(2, 0.3, -0.1)).norm(), 0, 1e-12);
    EXPECT_FALSE(three.error_velocity_mps || three.range_m[lost]);
    EXPECT_NEAR(*three.altitude_m, 50, 1e-9);
    EXPECT_FALSE(ping(level(), {.fewest_beams = 4}, noise).velocity);
  }
  noise.fade_db = {-100, 0, -100, 0};
  EXPECT_FALSE(ping(level(), {}, noise).velocity);
}

TEST(DvlPing, ErrorVelocityIsTheDisagreementOfThePairs) {
  PingNoise noise;
  noise.bed_mps = {0.01, 0.01, -0.01, -0.01};
  const auto sample = ping(level(), {}, noise);
  // 0.04 / (2 sqrt2 sin 30): the two pairs differ, and the velocity still equals the truth.
  EXPECT_NEAR(*sample.error_velocity_mps, -0.04 / std::numbers::sqrt2, 1e-12);
  EXPECT_NEAR((*sample.velocity - Vector3d(2, 0.3, -0.1)).norm(), 0, 1e-12);
}

TEST(DvlPing, TurnedBeamsLookBetweenTheAxesAndGiveTheSameVelocity) {
  const JanusHead head{.turn_rad = 45 * degree};
  const auto beams = beam_directions(head);
  const double s = std::sin(30 * degree) * std::sqrt(0.5);
  EXPECT_NEAR((beams[0] - Vector3d(s, -s, c30)).norm(), 0, 1e-12);   // port to port bow
  EXPECT_NEAR((beams[1] - Vector3d(-s, s, c30)).norm(), 0, 1e-12);   // starboard quarter
  EXPECT_NEAR((beams[2] - Vector3d(s, s, c30)).norm(), 0, 1e-12);    // starboard bow
  EXPECT_NEAR((beams[3] - Vector3d(-s, -s, c30)).norm(), 0, 1e-12);  // port quarter
  const auto sample = ping(tilted(level(), 5, 10), head);
  EXPECT_NEAR((*sample.velocity - Vector3d(2, 0.3, -0.1)).norm(), 0, 1e-12);
  EXPECT_NEAR(*sample.altitude_m, 50, 1e-9);
  // 2 s + 0.3 s - 0.1 cos 30 along the beam to the starboard bow.
  EXPECT_NEAR(*sample.beams[2].velocity_mps, 2.3 * s - 0.1 * c30, 1e-12);
}

TEST(WaterTrack, MeasuresAgainstTheMeanCurrentOfItsLayer) {
  OceanConfig ocean;
  ocean.bed.depth_m = 60;
  ocean.current = {{12, {0, 0, 0}}, {22, {1, 0.5, 0}}};
  const JanusHead head{.layer = WaterLayer{2, 10}};
  const auto water = dvl_ping(Frozen(tilted(level(), 0, 0, 90), ocean), {}, {}, head).water;
  ASSERT_TRUE(water.velocity);
  // The mean of the cubic step is half its height. The heading is east, so north is to port.
  EXPECT_NEAR((*water.velocity - Vector3d(2 - 0.25, 0.3 + 0.5, -0.1)).norm(), 0, 1e-12);
  EXPECT_NEAR(*water.error_velocity_mps, 0, 1e-12);
}

TEST(WaterTrack, InShearATiltedHeadsBeamsDisagree) {
  OceanConfig ocean;
  ocean.bed.depth_m = 200;
  ocean.current = {{0, {0, 0, 0}}, {40, {1, 0, 0}}};
  const JanusHead head{.layer = WaterLayer{4, 8}};
  const auto water = dvl_ping(Frozen(tilted(level(), 0, 25), ocean), {}, {}, head).water;
  EXPECT_GT(std::abs(*water.error_velocity_mps), 1e-3);
}

TEST(WaterTrack, IsLostWhereTheLayerMeetsTheBedOrTheSurface) {
  const JanusHead head{.layer = WaterLayer{10, 10}};
  EXPECT_TRUE(ping(level(10, 30.1), head).water.velocity);
  EXPECT_FALSE(ping(level(10, 29.9), head).water.velocity);
  EXPECT_TRUE(ping(level(10, 500), head).water.velocity);  // the bed is out of range
  EXPECT_FALSE(ping(level(10, 500)).water.velocity);       // no layer is configured
  EXPECT_FALSE(ping(level(-1, 500), head).water.velocity);
  // Upside down, the layer would be above the surface.
  EXPECT_FALSE(ping(tilted(level(10, 500), 180, 0), head).water.velocity);
}

TEST(WaterTrack, OverASlopeTheUphillBeamIsLostFirst) {
  const JanusHead head{.layer = WaterLayer{10, 32}};
  const auto water = dvl_ping(Frozen(level(), slope()), {}, {}, head).water;
  // 42 m along the axis are 48.5 m along a beam. The uphill beam meets the bed after 47.7 m.
  EXPECT_EQ(water.beam_good, (std::array{true, true, true, false}));
  EXPECT_TRUE(water.velocity);
  EXPECT_FALSE(water.error_velocity_mps);
}

}  // namespace dvl_test
}  // namespace drydock::sensor
