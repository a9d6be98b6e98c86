#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "tests/drivers/device/support.hpp"

/// The packets are put together by hand from the layout in the maker's example programs.
namespace drydock::device::test {
namespace wayfinder_driver_test {

using measurement::BottomVelocity;

constexpr float none = std::numeric_limits<float>::quiet_NaN();
enum Axes : std::uint8_t { of_beams, of_instrument, of_ship, of_earth };

void put_float(Octets& out, std::size_t offset, float value) {
  put(out, offset, 4, std::bit_cast<std::uint32_t>(value));
}

Octets packet(std::array<float, 4> velocity, Axes axes = of_instrument) {
  constexpr std::size_t data = 9;
  Octets p(98);
  p[0] = 0xAA, p[1] = 0x10, p[2] = 0x01, p[3] = 98, p[5] = 2, p[6] = 5, p[7] = 91;
  p[data + 1] = 0x10, p[data + 2] = 87;
  const std::array<std::uint8_t, 6> clock{26, 11, 23, 14, 3, 59};
  std::ranges::copy(clock, p.begin() + data + 12);
  put(p, data + 18, 2, 250);
  p[data + 20] = axes;
  for (std::size_t i = 0; i < 4; ++i) {
    put_float(p, data + 21 + 4 * i, velocity[i]);
    put_float(p, data + 37 + 4 * i, 10.0F + static_cast<float>(i));
  }
  put_float(p, data + 57, 1490.0F);
  unsigned sum = 0;
  for (std::size_t i = 0; i < 96; ++i) sum += p[i];
  put(p, 96, 2, sum);
  return p;
}

Ear hear(const Octets& bytes, const DriverOptions& o = options(Kind::dvl, "wayfinder")) {
  Ear ear;
  byte_driver(o)->receive(bytes, at_s(1), ear);
  return ear;
}

/// The maker's program for the BlueROV turns X, Y, Z by roll 180 and yaw 135 degrees and hands the
/// result times the interval to the autopilot as the way of the vehicle. That is a head with beam 3
/// at 45 degrees from the bow to starboard.
TEST(WayfinderDriver, VelocityIsThatOfTheMakersBlueRovProgram) {
  DriverOptions o = options(Kind::dvl, "wayfinder");
  o.mounting = {0, 0, 45 * degree};
  const auto v = hear(packet({0.5F, 1.25F, -0.125F, 0.0F}), o).all<BottomVelocity>().at(0).velocity;
  ASSERT_TRUE(v);
  const double c = std::cos(135 * degree), s = std::sin(135 * degree);
  EXPECT_NEAR(v->x(), c * 0.5 + s * 1.25, 1e-12);
  EXPECT_NEAR(v->y(), s * 0.5 - c * 1.25, 1e-12);
  EXPECT_NEAR(v->z(), 0.125, 1e-12);
}

TEST(WayfinderDriver, WithoutTheKeyItSaysOnceWhoseVelocityItTakes) {
  const Octets ping = packet({0.5F, 1.25F, -0.125F, 0.0F});
  const Ear ear = hear(ping + ping);
  EXPECT_EQ(ear.all<BottomVelocity>().size(), 2u);
  ASSERT_EQ(ear.reports.size(), 1u);
  EXPECT_NE(ear.reports[0].find("velocity_of"), std::string::npos);
}

TEST(WayfinderDriver, TheVelocityOfTheBedIsTurnedRound) {
  DriverOptions o = options(Kind::dvl, "wayfinder");
  o.dvl.velocity_of_bed = true;
  const Ear ear = hear(packet({0.5F, 1.25F, -0.125F, 0.0625F}), o);
  const auto m = ear.all<BottomVelocity>().at(0);
  ASSERT_TRUE(m.velocity);
  EXPECT_EQ(*m.velocity, Eigen::Vector3d(-1.25, -0.5, -0.125));
  EXPECT_TRUE(ear.reports.empty());
}

TEST(WayfinderDriver, BeamsThatStandAt30DegreesAreSolved) {
  DriverOptions o = options(Kind::dvl, "wayfinder");
  o.dvl.velocity_of_bed = false;
  // X = (b1 - b2) / (2 sin 30), Y = (b4 - b3) / (2 sin 30), Z = the sum / (4 cos 30).
  const auto m = hear(packet({0.5F, 0.25F, -0.5F, 0.75F}, of_beams), o).all<BottomVelocity>().at(0);
  ASSERT_TRUE(m.velocity);
  EXPECT_NEAR(m.velocity->x(), 1.25, 1e-9);
  EXPECT_NEAR(m.velocity->y(), 0.25, 1e-9);
  EXPECT_NEAR(m.velocity->z(), -1.0 / (4 * std::sqrt(0.75)), 1e-9);
  EXPECT_FALSE(m.error_velocity_mps);
}

TEST(WayfinderDriver, RangesSoundAndClockAreThoseOfThePing) {
  const auto m = hear(packet({0.5F, 1.25F, -0.125F, 0.0625F})).all<BottomVelocity>().at(0);
  EXPECT_EQ(m.range_m, (std::array<std::optional<double>, 4>{10.0, 11.0, 12.0, 13.0}));
  EXPECT_FALSE(m.altitude_m) << "the head has no tilt sensors";
  EXPECT_EQ(m.sound_speed_mps, 1490.0);
  EXPECT_EQ(m.error_velocity_mps, 0.0625);
  const std::chrono::sys_days day = std::chrono::year{2026} / 11 / 23;
  EXPECT_EQ(m.origin.device_time, day.time_since_epoch() + std::chrono::hours{14} +
                                      std::chrono::minutes{3} + std::chrono::milliseconds{59'250});
}

TEST(WayfinderDriver, WithoutBottomThereIsAMeasurementWithoutVelocityAndNothingToSay) {
  const Ear ear = hear(packet({none, none, none, none}));
  ASSERT_EQ(ear.all<BottomVelocity>().size(), 1u);
  EXPECT_FALSE(ear.all<BottomVelocity>()[0].velocity);
  EXPECT_TRUE(ear.reports.empty());
}

TEST(WayfinderDriver, EarthAxesWithoutAHeadingAreNoVelocityAndAreSaid) {
  const Ear ear = hear(packet({0.5F, 1.25F, -0.125F, 0.0F}, of_earth));
  EXPECT_FALSE(ear.all<BottomVelocity>().at(0).velocity);
  EXPECT_EQ(ear.reports.size(), 1u);
}

}  // namespace wayfinder_driver_test
}  // namespace drydock::device::test
