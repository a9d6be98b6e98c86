#include "tests/drivers/device/support.hpp"

/// Compasses on NMEA 2000 and NMEA 0183. The frames are written by hand from the field tables of
/// canboat's public PGN database, the sentences from the field lists of NMEA 0183.
namespace drydock::device::test {
namespace attitude_driver_test {

using measurement::AttitudeSample;
using measurement::HeadingReference;

constexpr std::uint32_t heading_id = 0x09F11227, turn_id = 0x09F11327, tilt_id = 0x0DF11927,
                        variation_id = 0x19F11A03;

struct Compass {
  explicit Compass(const DriverOptions& o = options(Kind::attitude, "nmea2000"))
      : driver(frame_driver(o)) {}
  void says(std::uint32_t id, std::initializer_list<unsigned> data, double at = 1) {
    driver->receive(can_frame(id, true, data), at_s(at), ear);
  }
  std::vector<AttitudeSample> heard() const { return ear.all<AttitudeSample>(); }
  Ear ear;
  std::unique_ptr<FrameDriver> driver;
};

DriverOptions mounted(double roll_deg, double pitch_deg, double yaw_deg, std::string protocol) {
  DriverOptions o = options(Kind::attitude, std::move(protocol));
  o.mounting = {roll_deg * degree, pitch_deg * degree, yaw_deg * degree};
  return o;
}

TEST(Nmea2000Attitude, ATrueHeadingIsTheTrueHeading) {
  Compass compass;  // 12345 * 0.0001 rad
  compass.says(heading_id, {0, 0x39, 0x30, 0xFF, 0x7F, 0xFF, 0x7F, 0xFC});
  const auto heard = compass.heard();
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_NEAR(heard[0].heading_rad.value(), 1.2345, 1e-12);
  EXPECT_NEAR(heard[0].true_heading_rad.value(), 1.2345, 1e-12);
  EXPECT_EQ(heard[0].reference, HeadingReference::true_north);
  EXPECT_FALSE(heard[0].deviation_rad || heard[0].variation_rad || heard[0].roll_rad ||
               heard[0].pitch_rad || heard[0].rate_of_turn_radps);
}

// 10000 * 0.0001 rad are shown; what is left obeys the law of the configuration.
TEST(Nmea2000Attitude, TheErrorThatTheRigFileKnowsIsTakenOff) {
  DriverOptions o = options(Kind::attitude, "nmea2000");
  o.compass_error_rad = {0.02, -0.15, 0.08};
  const auto shown = [&](double h) { return h + 0.02 - 0.15 * std::sin(h) + 0.08 * std::cos(h); };
  Compass compass(o), magnetic(o);
  compass.says(heading_id, {0, 0x10, 0x27, 0xFF, 0x7F, 0xFF, 0x7F, 0xFC});
  EXPECT_NEAR(shown(compass.heard().at(0).heading_rad.value()), 1, 1e-7);
  EXPECT_EQ(compass.heard()[0].true_heading_rad, compass.heard()[0].heading_rad);
  // Variation 0.12 rad: the error is that at the true heading.
  magnetic.says(heading_id, {0, 0x10, 0x27, 0xFF, 0x7F, 0xB0, 0x04, 0xFD});
  EXPECT_NEAR(shown(magnetic.heard().at(0).true_heading_rad.value()), 1.12, 1e-7);
}

TEST(Nmea2000Attitude, AMagneticHeadingBecomesTrueByDeviationAndVariation) {
  Compass compass;  // 6.2 rad magnetic, deviation -0.01, variation 0.12: 6.31 - 2 pi
  compass.says(heading_id, {0, 0x30, 0xF2, 0x9C, 0xFF, 0xB0, 0x04, 0xFD});
  const auto heard = compass.heard();
  EXPECT_EQ(heard.at(0).reference, HeadingReference::magnetic_north);
  EXPECT_NEAR(heard[0].heading_rad.value(), 6.2, 1e-12);
  EXPECT_NEAR(heard[0].deviation_rad.value(), -0.01, 1e-12);
  EXPECT_NEAR(heard[0].variation_rad.value(), 0.12, 1e-12);
  EXPECT_NEAR(heard[0].true_heading_rad.value(), 0.026814692820414, 1e-12);
}

TEST(Nmea2000Attitude, WithoutAVariationAMagneticHeadingIsNoTrueHeading) {
  Compass compass;
  compass.says(heading_id, {0, 0x10, 0x27, 0xFF, 0x7F, 0xFF, 0x7F, 0xFD});
  EXPECT_NEAR(compass.heard().at(0).heading_rad.value(), 1, 1e-12);
  EXPECT_FALSE(compass.heard()[0].true_heading_rad);
}

TEST(Nmea2000Attitude, TheVariationOfAnotherNodeMakesAMagneticHeadingTrue) {
  Compass compass;  // variation -0.05 rad, then 1 rad magnetic
  compass.says(variation_id, {0, 0xF4, 0xFF, 0xFF, 0x0C, 0xFE, 0xFF, 0xFF}, 0.5);
  compass.says(heading_id, {0, 0x10, 0x27, 0xFF, 0x7F, 0xFF, 0x7F, 0xFD});
  ASSERT_EQ(compass.heard().size(), 1U);
  EXPECT_NEAR(compass.heard()[0].variation_rad.value(), -0.05, 1e-12);
  EXPECT_NEAR(compass.heard()[0].true_heading_rad.value(), 0.95, 1e-12);
}

TEST(Nmea2000Attitude, RollPitchAndRateOfTurnKeepTheirSigns) {
  Compass compass;  // pitch 0.02, roll -0.1 rad; turn -0.05 rad/s = -1600000 / 32e6
  compass.says(tilt_id, {0, 0xFF, 0x7F, 0xC8, 0x00, 0x18, 0xFC, 0xFF});
  compass.says(turn_id, {0, 0x00, 0x96, 0xE7, 0xFF, 0xFF, 0xFF, 0xFF}, 1.1);
  const auto heard = compass.heard();
  EXPECT_NEAR(heard.at(0).pitch_rad.value(), 0.02, 1e-12);
  EXPECT_NEAR(heard[0].roll_rad.value(), -0.1, 1e-12);
  EXPECT_FALSE(heard[0].heading_rad);
  EXPECT_NEAR(heard.at(1).rate_of_turn_radps.value(), -0.05, 1e-12);
}

TEST(Nmea2000Attitude, WhatNoCompassSaysIsRefusedAndSaid) {
  Compass compass;  // 6.4 rad; a pitch of 2 rad
  compass.says(heading_id, {0, 0x00, 0xFA, 0xFF, 0x7F, 0xFF, 0x7F, 0xFC});
  compass.says(tilt_id, {0, 0xFF, 0x7F, 0x20, 0x4E, 0x00, 0x00, 0xFF}, 1.1);
  EXPECT_TRUE(compass.heard().empty());
  EXPECT_EQ(compass.ear.refusals.size(), 2U);
}

TEST(Nmea2000Attitude, OfTwoCompassesTheFirstHeardCounts) {
  Compass compass;
  compass.says(heading_id, {0, 0x10, 0x27, 0xFF, 0x7F, 0xFF, 0x7F, 0xFC});
  compass.says(0x09F11228, {0, 0x20, 0x4E, 0xFF, 0x7F, 0xFF, 0x7F, 0xFC}, 1.05);
  ASSERT_EQ(compass.heard().size(), 1U);
  EXPECT_NEAR(compass.heard()[0].heading_rad.value(), 1, 1e-12);
}

TEST(Nmea2000Attitude, ACompassTurnedByYawReadsThatMuchMore) {
  Compass compass(mounted(0, 0, 90, "nmea2000"));  // reads 1 rad: the bow is at 1 - pi/2
  compass.says(heading_id, {0, 0x10, 0x27, 0xFF, 0x7F, 0xFF, 0x7F, 0xFC});
  EXPECT_NEAR(compass.heard().at(0).heading_rad.value(), 1 + 1.5 * std::numbers::pi, 1e-12);
}

// Its x axis points to starboard: the body rolled by 0.2 rad to starboard is a compass with its
// bow 0.2 rad down, and its own roll is the body's pitch.
TEST(Nmea2000Attitude, ACompassTurnedByYawSwapsRollAndPitch) {
  Compass compass(mounted(0, 0, 90, "nmea2000"));  // reads pitch -0.2, roll 0
  compass.says(tilt_id, {0, 0xFF, 0x7F, 0x30, 0xF8, 0x00, 0x00, 0xFF});
  EXPECT_NEAR(compass.heard().at(0).roll_rad.value(), 0.2, 1e-12);
  EXPECT_NEAR(compass.heard()[0].pitch_rad.value(), 0, 1e-12);
}

struct Sentences {
  explicit Sentences(const DriverOptions& o = options(Kind::attitude, "nmea0183"))
      : driver(byte_driver(o)) {}
  void says(std::string_view body, double at = 1) { driver->receive(nmea(body), at_s(at), ear); }
  std::vector<AttitudeSample> heard() const { return ear.all<AttitudeSample>(); }
  Ear ear;
  std::unique_ptr<ByteDriver> driver;
};

TEST(Nmea0183Attitude, HdtIsATrueHeading) {
  Sentences compass;
  compass.says("HEHDT,274.07,T");
  ASSERT_EQ(compass.heard().size(), 1U);
  EXPECT_NEAR(compass.heard()[0].true_heading_rad.value(), 274.07 * degree, 1e-12);
  EXPECT_EQ(compass.heard()[0].reference, HeadingReference::true_north);
}

TEST(Nmea0183Attitude, HdtBesideThsIsTheSameHeadingTwice) {
  Sentences compass;
  compass.says("HETHS,10.5,A", 1);
  compass.says("HEHDT,10.5,T", 1.02);
  EXPECT_EQ(compass.heard().size(), 1U);
  compass.says("HEHDT,11.5,T", 5);
  EXPECT_EQ(compass.heard().size(), 2U);
}

TEST(Nmea0183Attitude, AHeadingThatIsNotValidIsNone) {
  Sentences compass;
  compass.says("HETHS,10.5,V");
  ASSERT_EQ(compass.heard().size(), 1U);
  EXPECT_FALSE(compass.heard()[0].heading_rad || compass.heard()[0].true_heading_rad);
}

TEST(Nmea0183Attitude, AHeadingTypedInOrBeyondTheCircleIsRefusedAndSaid) {
  Sentences compass;
  compass.says("HETHS,10.5,M", 1);
  compass.says("HEHDT,361,T", 2);
  EXPECT_TRUE(compass.heard().empty());
  EXPECT_EQ(compass.ear.refusals.size(), 2U);
}

TEST(Nmea0183Attitude, AMagneticHeadingBecomesTrueByDeviationAndVariation) {
  Sentences compass;  // 355 - 2 + 12.5 = 365.5
  compass.says("HCHDG,355,2,W,12.5,E");
  ASSERT_EQ(compass.heard().size(), 1U);
  const auto sample = compass.heard()[0];
  EXPECT_EQ(sample.reference, HeadingReference::magnetic_north);
  EXPECT_NEAR(sample.heading_rad.value(), 355 * degree, 1e-12);
  EXPECT_NEAR(sample.true_heading_rad.value(), 5.5 * degree, 1e-12);
}

TEST(Nmea0183Attitude, HdmHasNoVariationAndGivesNoTrueHeading) {
  Sentences compass;
  compass.says("APHDM,218.634,M");
  ASSERT_EQ(compass.heard().size(), 1U);
  EXPECT_NEAR(compass.heard()[0].heading_rad.value(), 218.634 * degree, 1e-12);
  EXPECT_EQ(compass.heard()[0].reference, HeadingReference::magnetic_north);
  EXPECT_FALSE(compass.heard()[0].true_heading_rad);
}

TEST(Nmea0183Attitude, OfSeveralSentencesTheOneThatSaysMostCounts) {
  Sentences compass;
  compass.says("HCHDG,10,,,1,E", 1);
  compass.says("HCHDM,10,M", 1.02);
  EXPECT_EQ(compass.heard().size(), 1U) << "HDM is the heading of HDG once more";
  compass.says("HEHDT,11,T", 1.5);
  compass.says("HCHDG,10,,,1,E", 2);
  EXPECT_EQ(compass.heard().size(), 2U) << "HDG is passed over while HDT comes";
  compass.says("HCHDM,12,M", 6);
  EXPECT_EQ(compass.heard().size(), 3U);
}

TEST(Nmea0183Attitude, AVariationBeyondHalfATurnIsRefusedAndSaid) {
  Sentences compass;
  compass.says("HCHDG,10,,,190,E");
  EXPECT_TRUE(compass.heard().empty());
  EXPECT_EQ(compass.ear.refusals.size(), 1U);
}

}  // namespace attitude_driver_test
}  // namespace drydock::device::test
