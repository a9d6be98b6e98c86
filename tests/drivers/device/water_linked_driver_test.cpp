#include "tests/drivers/device/support.hpp"

/// The sentences are written by hand from Water Linked's description, with its CRC-8.
namespace drydock::device::test {
namespace water_linked_driver_test {

using namespace std::chrono_literals;
using measurement::BottomVelocity;

Octets line(const std::string& body) {
  unsigned crc = 0;
  for (const unsigned char c : body) {
    for (unsigned bit = 0x80; bit != 0; bit >>= 1) {
      const bool carry = ((crc & 0x80) != 0) != ((c & bit) != 0);
      crc = (crc << 1 & 0xFF) ^ (carry ? 0x07 : 0);
    }
  }
  std::array<char, 8> tail{};
  std::snprintf(tail.data(), tail.size(), "*%02x\r\n", crc);
  return octets(body + tail.data());
}

Octets wrz(const std::string& velocity, const std::string& times, const std::string& status = "0") {
  return line("wrz," + velocity + ",0.003,1;0;0;0;1;0;0;0;1," + times + ",83.40," + status);
}

const std::string locked = "1.234,-0.056,0.078,y,6.98", lost = "0.000,0.000,0.000,n,-1.00";
const std::string times = "1795262400123456,1795262400198456";  // 75 ms apart

std::vector<BottomVelocity> heard(const Octets& bytes,
                                  DriverOptions o = options(Kind::dvl, "water-linked")) {
  Ear ear;
  byte_driver(o)->receive(bytes, at_s(1), ear);
  return ear.all<BottomVelocity>();
}

TEST(WaterLinkedDriver, VelocityInTheBodyAndAltitude) {
  DriverOptions o = options(Kind::dvl, "water-linked");
  o.mounting = {0, 0, 90 * degree};  // its x axis points to starboard
  const auto m = heard(wrz(locked, times), o).at(0);
  EXPECT_NEAR(m.velocity->x(), 0.056, 1e-12);
  EXPECT_NEAR(m.velocity->y(), 1.234, 1e-12);
  EXPECT_NEAR(m.velocity->z(), 0.078, 1e-12);
  EXPECT_EQ(m.altitude_m, 6.98);
  EXPECT_EQ(m.origin.device_time, 1795262400123456us);
}

/// A quarter turn about z: the DVL's x is the body's y, its y the body's -x.
TEST(WaterLinkedDriver, TheCovarianceTurnsIntoTheBodyAndComesBeforeTheRigsSigma) {
  DriverOptions o = options(Kind::dvl, "water-linked");
  o.mounting = {0, 0, 90 * degree};
  o.velocity_sigma_mps = 0.5;
  const auto bytes = line("wrz," + locked + ",0.003,4;1;2;1;9;3;2;3;16," + times + ",83.40,0");
  const auto m = heard(bytes, o).at(0);
  const Eigen::Matrix3d expected{{9, -1, -3}, {-1, 4, 2}, {-3, 2, 16}};
  ASSERT_TRUE(m.velocity_covariance);
  EXPECT_TRUE(m.velocity_covariance->isApprox(expected, 1e-12)) << *m.velocity_covariance;
  EXPECT_EQ(m.figure_of_merit_mps, 0.003);
  EXPECT_FALSE(heard(wrz(lost, times), o).at(0).velocity_covariance);
}

TEST(WaterLinkedDriver, VariancesOfZeroAreNoCovariance) {
  const auto bytes = line("wrz," + locked + ",0.003,0;0;0;0;0;0;0;0;0," + times + ",83.40,0");
  const auto m = heard(bytes).at(0);
  EXPECT_FALSE(m.velocity_covariance);
  EXPECT_EQ(m.figure_of_merit_mps, 0.003);
}

TEST(WaterLinkedDriver, AMeritOfZeroIsNoneAndLeavesTheRigsSigma) {
  DriverOptions o = options(Kind::dvl, "water-linked");
  o.velocity_sigma_mps = 0.5;
  const auto bytes = line("wrz," + locked + ",0.000,0;0;0;0;0;0;0;0;0," + times + ",83.40,0");
  const auto m = heard(bytes, o).at(0);
  EXPECT_FALSE(m.figure_of_merit_mps);
  EXPECT_EQ(m.velocity_covariance, Eigen::Matrix3d(0.25 * Eigen::Matrix3d::Identity()));
}

TEST(WaterLinkedDriver, NoLockIsNoVelocityButALivingDvl) {
  const auto m = heard(wrz(lost, times)).at(0);
  EXPECT_FALSE(m.velocity);
  EXPECT_FALSE(m.altitude_m);
}

TEST(WaterLinkedDriver, TheReportsOwnTimesSayHowOldItIs) {
  DriverOptions o = options(Kind::dvl, "water-linked");
  o.latency = 20ms;
  EXPECT_EQ(heard(wrz(locked, times), o).at(0).origin.valid_at, at_s(1) - 75ms);
  o.baud = 115200;
  const Octets bytes = wrz(locked, times);
  const std::chrono::nanoseconds on_wire{bytes.size() * 10 * 1'000'000'000 / 115200};
  EXPECT_EQ(heard(bytes, o).at(0).origin.valid_at, at_s(1) - on_wire - 75ms);
}

TEST(WaterLinkedDriver, TimesThatCannotBeGiveWayToTheConfiguredLatency) {
  DriverOptions o = options(Kind::dvl, "water-linked");
  o.latency = 20ms;
  for (const char* nonsense : {"20,10", "0,1795262400198456", ",14"}) {
    EXPECT_EQ(heard(wrz(locked, nonsense), o).at(0).origin.valid_at, at_s(1) - 20ms) << nonsense;
  }
}

TEST(WaterLinkedDriver, TheOldFormCountsWhileTheNewOneDoesNotCome) {
  const Octets old = line("wrx,83.40,1.5,0.1,0.2,0.003,7.00,y,0");
  EXPECT_NEAR(heard(old).at(0).velocity->x(), 1.5, 1e-12);
  const auto both = heard(wrz(locked, times) + old);
  ASSERT_EQ(both.size(), 1U);
  EXPECT_NEAR(both[0].velocity->x(), 1.234, 1e-12);
}

TEST(WaterLinkedDriver, WaterTrackAndTransducersAreNoBottomVelocity) {
  EXPECT_TRUE(heard(line("wrs,0.5,0.01,-0.02,y,0.015,1;0;0;0;1;0;0;0;1," + times + ",500,0") +
                    line("wru,0,0.412,7.61,-38,-86"))
                  .empty());
}

TEST(WaterLinkedDriver, HeatIsReportedOnce) {
  Ear ear;
  const auto driver = byte_driver(options(Kind::dvl, "water-linked"));
  driver->receive(wrz(locked, times, "1") + wrz(locked, times, "1"), at_s(1), ear);
  EXPECT_EQ(ear.reports.size(), 1U);
  EXPECT_EQ(ear.all<BottomVelocity>().size(), 2U);
}

}  // namespace water_linked_driver_test
}  // namespace drydock::device::test
