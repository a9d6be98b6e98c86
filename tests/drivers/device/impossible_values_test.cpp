#include "tests/drivers/device/support.hpp"

/// What no vehicle does is dropped and told. The limits: DVLs and logs measure up to 20 m/s, and
/// receivers are made to stop at 515 m/s (1000 knots).
namespace drydock::device::test {
namespace impossible_values_test {

using measurement::BottomVelocity;
using measurement::GnssFix;
using measurement::WaterSpeed;

Ear heard(Kind kind, const std::string& protocol, const Octets& bytes) {
  Ear ear;
  const auto driver = byte_driver(options(kind, protocol));
  driver->receive(bytes, at_s(1), ear);
  driver->finish(ear);
  return ear;
}

TEST(ImpossibleValues, AVelocityOfADvlInJsonThatNoVehicleHasIsDropped) {
  const auto ear =
      heard(Kind::dvl, "water-linked-json",
            octets(R"({"time":83.4,"vx":1000000000,"vy":0.1,"vz":0.2,"fom":0.003,"altitude":6.98,)"
                   R"("velocity_valid":true,"status":0,"format":"json_v3.3","type":"velocity"})"
                   "\r\n"));
  const auto samples = ear.all<BottomVelocity>();
  ASSERT_EQ(samples.size(), 1u);
  EXPECT_FALSE(samples[0].velocity);
  EXPECT_FALSE(samples[0].figure_of_merit_mps);
  EXPECT_EQ(samples[0].altitude_m, 6.98) << "the rest of the sample stays";
  EXPECT_EQ(ear.refusals.size(), 1u);
}

TEST(ImpossibleValues, ASpeedThroughTheWaterThatNoVehicleHasIsDropped) {
  const auto ear = heard(Kind::emlog, "nmea0183", nmea("VDVHW,,T,,M,1000000,N,,K"));
  EXPECT_TRUE(ear.all<WaterSpeed>().empty());
  EXPECT_EQ(ear.refusals.size(), 1u);
}

TEST(ImpossibleValues, AHeightAndAGroundSpeedThatNoReceiverSaysAreDropped) {
  auto epoch = nmea("GPGGA,100000.00,5321.6802,N,00630.3372,W,1,08,1.03,9999999,M,55.2,M,,");
  const auto rmc = nmea("GPRMC,100000.00,A,5321.6802,N,00630.3372,W,99999.0,090.0,261126,,,A");
  epoch.insert(epoch.end(), rmc.begin(), rmc.end());
  const auto ear = heard(Kind::gnss, "nmea0183", epoch);
  const auto fixes = ear.all<GnssFix>();
  ASSERT_EQ(fixes.size(), 1u);
  EXPECT_TRUE(fixes[0].position);
  EXPECT_FALSE(fixes[0].mean_sea_level_height_m);
  EXPECT_FALSE(fixes[0].ground_speed_mps);
  EXPECT_GE(ear.refusals.size(), 2u);
}

}  // namespace impossible_values_test
}  // namespace drydock::device::test
