#include <cmath>

#include "drivers/device/dvl/sound_speed.hpp"
#include "tests/drivers/device/support.hpp"

/// The test builds ensembles from the offsets in Teledyne's Pathfinder DVL Guide (tables 32-47).
namespace drydock::device::test {
namespace dvl_driver_test {

using namespace std::chrono_literals;
using measurement::BottomVelocity;

struct Bed {
  std::array<int, 4> velocity_mmps{};  ///< of the bed, as on the wire
  std::array<int, 4> range_cm{1000, 1000, 1000, 1000};
  std::uint8_t transform = 0x10;  ///< ship axes, tilts not used
  int pitch_cdeg = 0, roll_cdeg = 0;
  bool faces_up = false;
  int salinity_ppt = 35;
};

Octets ensemble(const Bed& bed) {
  constexpr std::size_t header = 6 + 3 * 2, fixed = header, variable = fixed + 59,
                        track = variable + 65, end = track + 81;
  Octets out(end + 2, 0);
  put(out, 0, 2, 0x7F7F);
  put(out, 2, 2, end);
  out[5] = 3;
  put(out, 6, 2, fixed);
  put(out, 8, 2, variable);
  put(out, 10, 2, track);

  put(out, fixed, 2, 0x0000);
  put(out, fixed + 4, 2, bed.faces_up ? 0x028B : 0x020B);  // 30 degrees, convex, 600 kHz
  out[fixed + 8] = 4;
  out[fixed + 25] = bed.transform;

  put(out, variable, 2, 0x0080);
  const std::array<std::uint8_t, 7> clock{26, 3, 4, 5, 6, 7, 50};
  std::copy(clock.begin(), clock.end(), out.begin() + variable + 4);
  put(out, variable + 14, 2, 1500);
  put(out, variable + 16, 2, 100);  // 10 m deep
  put(out, variable + 18, 2, 9000);
  put(out, variable + 20, 2, bed.pitch_cdeg);
  put(out, variable + 22, 2, bed.roll_cdeg);
  put(out, variable + 24, 2, bed.salinity_ppt);
  put(out, variable + 26, 2, 1000);  // 10 deg C

  put(out, track, 2, 0x0600);
  for (std::size_t i = 0; i < 4; ++i) {
    put(out, track + 16 + 2 * i, 2, bed.range_cm[i]);
    put(out, track + 24 + 2 * i, 2, bed.velocity_mmps[i]);
  }
  int sum = 0;
  for (std::size_t i = 0; i < end; ++i) sum += out[i];
  put(out, end, 2, sum % 65536);
  return out;
}

BottomVelocity heard(const Bed& bed, DriverOptions o = options(Kind::dvl, "pd0")) {
  Ear ear;
  byte_driver(o)->receive(ensemble(bed), at_s(1), ear);
  const auto all = ear.all<BottomVelocity>();
  EXPECT_EQ(all.size(), 1U);
  return all.empty() ? BottomVelocity{} : all[0];
}

TEST(DvlDriver, VehicleMovesAgainstTheBedsMotion) {
  // Ship axes: starboard, forward, mast. The bed moves 1.5 m/s astern, 0.2 to port, 0.1 up.
  const auto v = heard({.velocity_mmps = {-200, -1500, 100, 4}}).velocity;
  ASSERT_TRUE(v);
  EXPECT_NEAR(v->x(), 1.5, 1e-12);
  EXPECT_NEAR(v->y(), 0.2, 1e-12);
  EXPECT_NEAR(v->z(), 0.1, 1e-12);  // the vehicle sinks: positive down
}

TEST(DvlDriver, MountingTurnsTheSensorIntoTheBody) {
  DriverOptions o = options(Kind::dvl, "pd0");
  o.mounting = {0, 0, 45 * degree};  // its bow axis points 45 degrees to starboard
  const auto v = heard({.velocity_mmps = {0, -1000, 0, 0}}, o).velocity;
  EXPECT_NEAR(v->x(), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(v->y(), std::sqrt(0.5), 1e-12);
}

/// Teledyne's coordinate transformation booklet: d (b1 + b2 - b3 - b4), d = a / sqrt 2, a = 1 / (2
/// sin 30 degrees) = 1. The wire has velocities of the bed: all four components turn round.
TEST(DvlDriver, FourGoodBeamsGiveTheErrorVelocity) {
  const auto m = heard({.velocity_mmps = {30, 20, 5, 5}, .transform = 0x00});
  EXPECT_NEAR(m.error_velocity_mps.value(), -0.040 / std::sqrt(2), 1e-9);
  const auto three = heard({.velocity_mmps = {30, 20, 5, -32768}, .transform = 0x00});
  EXPECT_FALSE(three.error_velocity_mps);
}

TEST(DvlDriver, NoBottomLockIsNoVelocityButALivingDvl) {
  const auto m = heard({.velocity_mmps = {-32768, -32768, -32768, -32768}, .range_cm = {}});
  EXPECT_FALSE(m.velocity);
  EXPECT_FALSE(m.error_velocity_mps);
  EXPECT_FALSE(m.altitude_m);
  EXPECT_FALSE(m.range_m[0]);
}

TEST(DvlDriver, AltitudeOfALevelVehicleIsTheRange) {
  EXPECT_NEAR(heard({.range_cm = {1200, 1200, 1200, 1200}}).altitude_m.value(), 12, 1e-12);
}

TEST(DvlDriver, AltitudeOverAFlatBedIsTrueUnderTilt) {
  // Closed form: 20 m above the bed, pitch 10 degrees, beams 30 degrees fore and aft. A beam at
  // angle b +- 10 degrees from the vertical has the slant 20 / cos. Its component is cos(30) times
  // that.
  const auto component = [](double from_vertical_deg) {
    return 20 / std::cos(from_vertical_deg * degree) * std::cos(30 * degree);
  };
  const int fore = static_cast<int>(std::lround(100 * component(40)));
  const int aft = static_cast<int>(std::lround(100 * component(20)));
  const auto m = heard({.range_cm = {0, 0, fore, aft}, .pitch_cdeg = 1000});
  EXPECT_NEAR(m.altitude_m.value(), 20, 0.01);
}

TEST(DvlDriver, OneBeamOfAPairIsNoAltitude) {
  EXPECT_FALSE(heard({.range_cm = {1000, 0, 0, 1000}}).altitude_m);
}

TEST(DvlDriver, KeepsTheDevicesOwnClockAttitudeAndSoundSpeed) {
  const auto m = heard({.pitch_cdeg = -250, .roll_cdeg = 125});
  using namespace std::chrono;
  const auto clock = sys_days{2026y / March / 4} + 5h + 6min + 7s + 500ms;
  EXPECT_EQ(m.origin.device_time, clock.time_since_epoch());
  EXPECT_NEAR(m.heading_rad.value(), 90 * degree, 1e-12);
  EXPECT_NEAR(m.pitch_rad.value(), -2.5 * degree, 1e-12);
  EXPECT_NEAR(m.roll_rad.value(), 1.25 * degree, 1e-12);
  EXPECT_EQ(m.sound_speed_mps, 1500);
}

TEST(DvlDriver, AnUpwardFacingHeadsEnsembleHoldsTheBottomTrackOfItsTwinInShipAxes) {
  // A vehicle with two heads sends both in turn, and both ensembles carry what the lower head saw.
  const auto m = heard({.velocity_mmps = {-200, -1500, 100, 4}, .faces_up = true});
  ASSERT_TRUE(m.velocity);
  EXPECT_NEAR(m.velocity->x(), 1.5, 1e-12);
  EXPECT_NEAR(m.velocity->y(), 0.2, 1e-12);
  EXPECT_NEAR(m.range_m[0].value(), 10, 1e-12);
  EXPECT_NEAR(m.altitude_m.value(), 10, 1e-12);
}

TEST(DvlDriver, AnUpwardFacingHeadsOwnAxesAreNotOfTheBedAndThatIsSaid) {
  Ear ear;
  const auto driver = byte_driver(options(Kind::dvl, "pd0"));
  for (double s = 1; s < 4; ++s)
    driver->receive(
        ensemble({.velocity_mmps = {-200, -1500, 100, 4}, .transform = 0x08, .faces_up = true}),
        at_s(s), ear);
  ASSERT_EQ(ear.all<BottomVelocity>().size(), 3U);
  EXPECT_FALSE(ear.all<BottomVelocity>()[0].velocity);
  EXPECT_FALSE(ear.all<BottomVelocity>()[0].range_m[0]);
  ASSERT_EQ(ear.reports.size(), 1U) << "once, not for each ensemble";
  EXPECT_NE(ear.reports[0].find("upward-facing"), std::string::npos);
}

TEST(DvlDriver, TheRigDecidesWhetherShipVelocitiesComeLevelled) {
  // Bow up by 20 degrees. A levelled velocity of 1 m/s ahead is cos 20 along the bow, and it sinks
  // with sin 20 in the body's axes.
  const Bed says_levelled{.velocity_mmps = {0, -1000, 0, 0}, .transform = 0x14, .pitch_cdeg = 2000};
  const auto by_the_wire = heard(says_levelled).velocity;
  EXPECT_NEAR(by_the_wire->x(), std::cos(20 * degree), 1e-12);
  EXPECT_NEAR(by_the_wire->z(), std::sin(20 * degree), 1e-12);
  DriverOptions o = options(Kind::dvl, "pd0");
  o.dvl.levelled = false;
  const auto by_the_rig = heard(says_levelled, o).velocity;
  EXPECT_NEAR(by_the_rig->x(), 1, 1e-12);
  EXPECT_NEAR(by_the_rig->z(), 0, 1e-12);
}

TEST(DvlDriver, AWrongSpeedOfSoundIsPutRightInVelocitiesAndRanges) {
  DriverOptions o = options(Kind::dvl, "pd0");
  o.dvl.sound_speed.source = SoundSpeedOptions::Source::fixed;
  o.dvl.sound_speed.fixed_mps = 1470;  // the head was set to 1500: 0.98 of all
  const auto m = heard({.velocity_mmps = {-200, -1500, 100, 4}}, o);
  EXPECT_NEAR(m.velocity->x(), 1.47, 1e-12);
  EXPECT_NEAR(m.velocity->y(), 0.196, 1e-12);
  EXPECT_NEAR(m.range_m[0].value(), 9.8, 1e-12);
  EXPECT_NEAR(m.altitude_m.value(), 9.8, 1e-12);
  EXPECT_EQ(m.sound_speed_mps, 1470);
}

TEST(DvlDriver, TheSpeedOfSoundIsComputedFromWhatTheDvlMeasures) {
  DriverOptions o = options(Kind::dvl, "pd0");
  o.dvl.sound_speed.source = SoundSpeedOptions::Source::computed;
  // Mackenzie's equation at 10 deg C, 35 ppt, 10 m by hand: 1448.96 + 45.91 - 5.304 + 0.2374 +
  // 0.163 + 0.00002 = 1489.966 m/s. At 31 ppt, 4 * 1.34 less and 4 * 0.1025 more.
  EXPECT_NEAR(heard({}, o).sound_speed_mps.value(), 1489.966, 1e-3);
  EXPECT_NEAR(heard({.salinity_ppt = 31}, o).sound_speed_mps.value(), 1485.016, 1e-3);
  o.dvl.sound_speed.salinity_ppt = 35;  // the rig knows better than the DVL
  EXPECT_NEAR(heard({.salinity_ppt = 31}, o).sound_speed_mps.value(), 1489.966, 1e-3);
}

TEST(DvlDriver, WithoutATemperatureTheVelocityStaysAsSentAndThatIsSaid) {
  DriverOptions o = options(Kind::dvl, "water-linked");
  o.dvl.sound_speed.source = SoundSpeedOptions::Source::computed;
  o.dvl.sound_speed.set_mps = 1500;
  SoundSpeedCorrection correction(o.dvl.sound_speed);
  BottomVelocity sample;
  sample.velocity = Eigen::Vector3d{1, 0, 0};
  Ear ear;
  correction.apply(sample, {}, ear);
  correction.apply(sample, {}, ear);
  EXPECT_EQ(sample.velocity->x(), 1);
  ASSERT_EQ(ear.reports.size(), 1U);
  EXPECT_NE(ear.reports[0].find("temperature"), std::string::npos);
}

/// Ensemble 5 of fixtures/pd0/NOTE.md: 0.25012 m/s to starboard (high resolution), 1.5 ahead (high
/// resolution is bad), 152 ms old.
Octets pathfinder() {
  constexpr std::size_t size = 12 + 6 + 59 + 65 + 81 + 66 + 33 + 87 + 2;
  const Octets all = read_all(DRYDOCK_SOURCE_DIR "/fixtures/pd0/golden.pd0");
  return {all.end() - size, all.end()};
}

TEST(DvlDriver, TheFinestVelocityAndRangeThatAnEnsembleHas) {
  Ear ear;
  byte_driver(options(Kind::dvl, "pd0"))->receive(pathfinder(), at_s(1), ear);
  ASSERT_EQ(ear.heard.size(), 1U);
  const auto m = ear.all<BottomVelocity>()[0];
  EXPECT_NEAR(m.velocity->x(), 1.5, 1e-12);
  EXPECT_NEAR(m.velocity->y(), 0.25012, 1e-12);
  EXPECT_NEAR(m.velocity->z(), 0.03998, 1e-12);
  EXPECT_NEAR(m.error_velocity_mps.value(), -0.00301, 1e-12);
  EXPECT_NEAR(m.altitude_m.value(), 12.6543, 1e-12);
  EXPECT_NEAR(m.range_m[0].value(), 12.34, 1e-12);
}

TEST(DvlDriver, TheAgeOfTheBottomEchoesCountsBeforeTheConfiguredLatency) {
  DriverOptions o = options(Kind::dvl, "pd0");
  o.baud = 115200;
  o.latency = 70ms;
  const Octets bytes = pathfinder();
  Ear ear;
  byte_driver(o)->receive(bytes, at_s(1), ear);
  const auto on_wire = std::chrono::nanoseconds{bytes.size() * 10 * 1'000'000'000 / 115200};
  EXPECT_EQ(ear.all<BottomVelocity>().at(0).origin.valid_at, at_s(1) - on_wire - 152ms);
}

TEST(DvlDriver, NoEnsembleIsLostAfterADamagedOne) {
  Octets damaged = ensemble({});
  damaged[40] ^= 0x01;
  Ear ear;
  const auto driver = byte_driver(options(Kind::dvl, "pd0"));
  driver->receive(damaged + ensemble({}), at_s(1), ear);
  EXPECT_EQ(ear.all<BottomVelocity>().size(), 1U);
  EXPECT_GE(driver->counters().bad_checksums, 1U);
}

}  // namespace dvl_driver_test
}  // namespace drydock::device::test
