#include "tests/drivers/device/support.hpp"

/// Sentences and their meaning, from real logs and test suites of other programs, as named.
namespace drydock::device::test {
namespace emlog_driver_test {

using measurement::WaterSpeed;

std::vector<WaterSpeed> speeds_of(std::string_view lines, const DriverOptions& o) {
  Ear ear;
  byte_driver(o)->receive(octets(lines), at_s(1), ear);
  return ear.all<WaterSpeed>();
}

std::vector<WaterSpeed> speeds_of(std::string_view lines) {
  return speeds_of(lines, options(Kind::emlog, "nmea0183"));
}

TEST(EmLogDriver, NasaLogSpeaksInKnotsWhateverItsKilometresSay) {
  const auto speeds = speeds_of("$HCVHW,,,,,0.2,N,0,K*5B\r\n");
  ASSERT_EQ(speeds.size(), 1U);
  EXPECT_NEAR(speeds[0].longitudinal_mps.value(), 0.2 * knot, 1e-12);
  EXPECT_FALSE(speeds[0].transverse_mps);
}

TEST(EmLogDriver, SpeedThroughTheWaterAsSignalKReadsIt) {
  EXPECT_NEAR(speeds_of("$IIVHW,,T,,M,06.12,N,11.33,K*50\r\n").at(0).longitudinal_mps.value(),
              3.1484, 5e-5);
}

TEST(EmLogDriver, ALogThatShowsTwoPercentTooMuchIsPutRight) {
  DriverOptions o = options(Kind::emlog, "nmea0183");
  o.speed_scale = 1.02;
  EXPECT_NEAR(speeds_of("$VMVBW,-7.1,0.1,A,,,V,,V,,V*65\r\n", o).at(0).longitudinal_mps.value(),
              -7.1 * knot / 1.02, 1e-12);
}

TEST(EmLogDriver, ALogThatIsMountedBackwardsNeedsNoTransverseSpeed) {
  DriverOptions o = options(Kind::emlog, "nmea0183");
  o.mounting = {0, 0, 180 * degree};
  const auto backwards = speeds_of("$VDVBW,-0.08,,A,,,V,,V,,V*7D\r\n", o).at(0);
  EXPECT_NEAR(backwards.longitudinal_mps.value(), 0.08 * knot, 1e-12);
  EXPECT_FALSE(backwards.transverse_mps);
  o.mounting = {180 * degree, 0, 0};  // upside down: x stays
  EXPECT_NEAR(speeds_of("$VDVBW,-0.08,,A,,,V,,V,,V*7D\r\n", o).at(0).longitudinal_mps.value(),
              -0.08 * knot, 1e-12);
  o.mounting = {0, 0, 1 * degree};
  EXPECT_FALSE(speeds_of("$VDVBW,-0.08,,A,,,V,,V,,V*7D\r\n", o).at(0).longitudinal_mps);
}

TEST(EmLogDriver, AsternIsNegative) {
  EXPECT_NEAR(speeds_of("$VDVBW,-0.08,,A,,,V,,V,,V*7D\r\n").at(0).longitudinal_mps.value(),
              -0.08 * knot, 1e-12);
}

TEST(EmLogDriver, EmptySpeedIsNoNumberButALivingLog) {
  const auto speeds = speeds_of("$IIVHW,340,T,350,M,,N,,K*54\r\n");
  ASSERT_EQ(speeds.size(), 1U);
  EXPECT_FALSE(speeds[0].longitudinal_mps);
}

TEST(EmLogDriver, TransverseSpeedIsPositiveToStarboard) {
  const auto speeds = speeds_of("$VMVBW,-7.1,0.1,A,,,V,,V,,V*65\r\n");
  EXPECT_NEAR(speeds.at(0).longitudinal_mps.value(), -7.1 * knot, 1e-12);
  EXPECT_NEAR(speeds.at(0).transverse_mps.value(), 0.1 * knot, 1e-12);
}

TEST(EmLogDriver, GroundSpeedNeverComesOutAsWaterSpeed) {
  const auto speeds = speeds_of("$VDVBW,55.42,,V,424.33,2321.22,V*49\r\n");  // all values are void
  ASSERT_EQ(speeds.size(), 1U);
  EXPECT_FALSE(speeds[0].longitudinal_mps);

  Ear ear;
  byte_driver(options(Kind::emlog, "nmea0183"))
      ->receive(nmea("VDVBW,,,V,10.5,0.4,A"), at_s(1), ear);  // water void, ground valid
  EXPECT_FALSE(ear.all<WaterSpeed>().at(0).longitudinal_mps);
  EXPECT_FALSE(ear.all<WaterSpeed>().at(0).transverse_mps);
}

TEST(EmLogDriver, WaterAndGroundTogetherGiveTheWater) {
  const auto speeds = speeds_of("$VDVBW,10.1,0.5,A,10.5,0.4,A,,,,*54\r\n");
  EXPECT_NEAR(speeds.at(0).longitudinal_mps.value(), 10.1 * knot, 1e-12);
  EXPECT_NEAR(speeds.at(0).transverse_mps.value(), 0.5 * knot, 1e-12);
}

TEST(EmLogDriver, SpeedThatVbwSaysIsNotSaidAgainByVhw) {
  const auto speeds =
      speeds_of("$VDVBW,-0.08,,A,,,V,,V,,V*7D\r\n$VDVHW,,T,,M,-0.08,N,-0.15,K*4B\r\n");
  EXPECT_EQ(speeds.size(), 1U);
}

TEST(EmLogDriver, DistanceIsThatThroughTheWater) {
  const auto speeds = speeds_of("$IIVLW,115.2,N,12.3,N*7A\r\n");
  EXPECT_NEAR(speeds.at(0).distance_m.value(), 115.2 * 1852, 1e-9);
  EXPECT_TRUE(speeds_of("$SDVLW,,N,545.6,N,1109.4,N,393.6,N*44\r\n").empty());  // total empty
}

TEST(EmLogDriver, ASpeedHasTheRigsSigmaAndADistanceHasNone) {
  DriverOptions o = options(Kind::emlog, "nmea0183");
  o.velocity_sigma_mps = 0.05;
  Ear ear;
  byte_driver(o)->receive(nmea("VMVHW,,,,,3.50,N,,") + nmea("VMVLW,7803.2,N,0.0,N"), at_s(1), ear);
  const auto all = ear.all<measurement::WaterSpeed>();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].sigma_mps, 0.05);
  EXPECT_FALSE(all[1].sigma_mps);
}

TEST(EmLogDriver, BadChecksumGivesNothing) {
  EXPECT_TRUE(speeds_of("$VDVBW,8.2,0.5,A,8.1,0.4,A,8.3,A,8.2,A*57\r\n").empty());
}

TEST(EmLogDriver, TurnedLogNeedsBothAxes) {
  DriverOptions turned = options(Kind::emlog, "nmea0183");
  turned.mounting = {0, 0, 90 * degree};  // its x axis points to starboard
  const auto speeds = speeds_of("$VMVBW,-7.1,0.1,A,,,V,,V,,V*65\r\n", turned);
  EXPECT_NEAR(speeds.at(0).longitudinal_mps.value(), -0.1 * knot, 1e-12);
  EXPECT_NEAR(speeds.at(0).transverse_mps.value(), -7.1 * knot, 1e-12);
  EXPECT_FALSE(speeds_of("$HCVHW,,,,,0.2,N,0,K*5B\r\n", turned).at(0).longitudinal_mps);
}

}  // namespace emlog_driver_test
}  // namespace drydock::device::test
