#include "tests/drivers/device/support.hpp"

/// The sentences are written by hand from the public description of their fields.
namespace drydock::device::test {
namespace nortek_driver_test {

using namespace std::chrono_literals;
using measurement::BottomVelocity;

Octets pnorbt7(const std::string& velocity, const std::string& age_ms = "-75.500") {
  return nmea("PNORBT7,1795262400.2500,61.250," + age_ms + "," + velocity +
              ",0.0031,7.01,7.02,0.00,7.04");
}

std::vector<BottomVelocity> heard_nortek(const Octets& bytes, DriverOptions o) {
  Ear ear;
  byte_driver(o)->receive(bytes, at_s(1), ear);
  return ear.all<BottomVelocity>();
}

TEST(NortekDriver, VelocityInTheBodyRangesAndNoAltitude) {
  DriverOptions o = options(Kind::dvl, "nortek");
  o.mounting = {0, 0, 90 * degree};  // its x axis points to starboard
  const auto m = heard_nortek(pnorbt7("1.2345,-0.0560,0.0780"), o).at(0);
  EXPECT_NEAR(m.velocity->x(), 0.056, 1e-12);
  EXPECT_NEAR(m.velocity->y(), 1.2345, 1e-12);
  EXPECT_NEAR(m.velocity->z(), 0.078, 1e-12);
  EXPECT_EQ(m.range_m[1], 7.02);
  EXPECT_FALSE(m.range_m[2] || m.altitude_m);
  // The trigger and the 61.25 ms to the echo. A Unix time in a double has an error below 1 us.
  EXPECT_LT(std::chrono::abs(*m.origin.device_time - (1795262400s + 250ms + 61'250us)), 1us);
}

TEST(NortekDriver, TheFigureOfMeritComesBeforeTheRigsSigma) {
  DriverOptions o = options(Kind::dvl, "nortek");
  o.velocity_sigma_mps = 0.5;
  const auto told = heard_nortek(pnorbt7("1,0,0"), o).at(0);
  EXPECT_EQ(told.figure_of_merit_mps, 0.0031);
  EXPECT_FALSE(told.velocity_covariance);
  const auto bad_merit = nmea("PNORBT7,1795262400.2500,61.250,-75.5,1,0,0,10.0,7,7,7,7");
  const auto untold = heard_nortek(bad_merit, o).at(0);
  EXPECT_FALSE(untold.figure_of_merit_mps);
  EXPECT_EQ(untold.velocity_covariance, Eigen::Matrix3d(0.25 * Eigen::Matrix3d::Identity()));
}

TEST(NortekDriver, OneBadComponentIsNoVelocity) {
  const auto o = options(Kind::dvl, "nortek");
  EXPECT_FALSE(heard_nortek(pnorbt7("1.2345,-32.7680,0.0780"), o).at(0).velocity);
}

TEST(NortekDriver, TheSentenceSaysHowOldItIs) {
  DriverOptions o = options(Kind::dvl, "nortek");
  o.latency = 20ms;
  const auto valid_at = [&](const std::string& age_ms) {
    return heard_nortek(pnorbt7("1,0,0", age_ms), o).at(0).origin.valid_at;
  };
  EXPECT_EQ(valid_at("-75.500"), at_s(1) - 75500us);
  EXPECT_EQ(valid_at("3.000"), at_s(1) - 20ms) << "an echo to come";
  EXPECT_EQ(valid_at("-9000.0"), at_s(1) - 20ms) << "an echo of long ago";
  EXPECT_EQ(valid_at(""), at_s(1) - 20ms);
}

TEST(NortekDriver, APingTimeThatNoClockHasIsRefusedAndTheVelocityKept) {
  for (const char* time : {"1e300", "-1e300", "-1", "4294967296"}) {
    Ear ear;
    const Octets sentence =
        nmea("PNORBT7," + std::string(time) + ",61.250,-75.500,1,2,3,0.0031,7.01,7.02,0.00,7.04");
    byte_driver(options(Kind::dvl, "nortek"))->receive(sentence, at_s(1), ear);
    const auto all = ear.all<BottomVelocity>();
    ASSERT_EQ(all.size(), 1U) << time;
    EXPECT_FALSE(all[0].origin.device_time) << time;
    EXPECT_TRUE(all[0].velocity) << time;
    EXPECT_EQ(ear.refusals.size(), 1U) << time;
  }
}

TEST(NortekDriver, OneBeamOrSpeedAloneIsNoBodyVelocity) {
  const auto bytes = nmea("PNORBT4,61.250,-75.500,1.236,357.4,0.00310,7.02") +
                     nmea("PNORBT0,2,211126,114000.2500,61.2,-75.5,-0.5120,0.0040,7.02,0x0F");
  EXPECT_TRUE(heard_nortek(bytes, options(Kind::dvl, "nortek")).empty());
}

}  // namespace nortek_driver_test
}  // namespace drydock::device::test
