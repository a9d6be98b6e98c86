#include "drivers/wire/ubx/ubx_solution.hpp"

#include <gtest/gtest.h>

#include "drivers/wire/ubx/ubx.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

/// Frames 10 to 16 of fixtures/ubx/NOTE.md: one epoch of a receiver before NAV-PVT.
namespace drydock::wire::testing {
namespace ubx_solution_test {

using namespace std::chrono_literals;

template <class M>
M golden() {
  static const auto reading = read_stream<Ubx>(fixture("ubx/golden.ubx"));
  return reading.all<M>().at(0);
}

TEST(UbxSolution, NavSolGivesThePositionThatGpsdReads) {
  const auto m = golden<NavSol>();
  EXPECT_EQ(m.itow, 116017s);
  EXPECT_EQ(m.itow_fraction, -123456ns);
  EXPECT_EQ(m.gps_week, 1916);
  EXPECT_TRUE(m.time_known && m.fix_ok && !m.differential);
  EXPECT_EQ(m.fix_type, UbxFixType::three_d);
  EXPECT_DOUBLE_EQ(*m.position_ecef_m[0], 4286406.18);
  EXPECT_DOUBLE_EQ(*m.position_ecef_m[1], 645600.20);
  EXPECT_DOUBLE_EQ(*m.position_ecef_m[2], 4663669.04);
  EXPECT_DOUBLE_EQ(*m.velocity_ecef_mps[0], -1.03);
  EXPECT_DOUBLE_EQ(*m.velocity_ecef_mps[2], 1.05);
  EXPECT_DOUBLE_EQ(*m.position_accuracy_m, 5.12);
  EXPECT_DOUBLE_EQ(*m.speed_accuracy_mps, 0.35);
  EXPECT_DOUBLE_EQ(*m.position_dop, 1.87);
  EXPECT_EQ(m.satellites_used, 9);
}

TEST(UbxSolution, AFixTypeAloneVouchesForNothing) {
  Buffer payload(52, 0x11);
  payload[10] = 3, payload[11] = 0x0C;  // 3D, but outside the masks
  NavSol m;
  ASSERT_TRUE(read(payload, m));
  EXPECT_FALSE(m.position_ecef_m[0] || m.velocity_ecef_mps[0]);
  payload[10] = 5, payload[11] = 0x0D;  // time only
  ASSERT_TRUE(read(payload, m = {}));
  EXPECT_FALSE(m.position_ecef_m[0]);
  payload[10] = 0, payload[11] = 0x01;
  ASSERT_TRUE(read(payload, m = {}));
  EXPECT_FALSE(m.position_ecef_m[0] || m.gps_week || m.time_known);
}

TEST(UbxSolution, PositionVelocityAndStatusAreThatOfTheDocumentsLayout) {
  const auto position = golden<NavPosllh>();
  EXPECT_NEAR(degrees(*position.latitude_rad), 47.2852332, 1e-12);
  EXPECT_NEAR(degrees(*position.longitude_rad), 8.565265, 1e-12);
  EXPECT_DOUBLE_EQ(*position.ellipsoidal_height_m, 456.789);
  EXPECT_DOUBLE_EQ(*position.mean_sea_level_height_m, 409.123);
  EXPECT_DOUBLE_EQ(*position.horizontal_accuracy_m, 4.1);
  EXPECT_DOUBLE_EQ(*position.vertical_accuracy_m, 3.07);
  const auto velocity = golden<NavVelned>();
  EXPECT_DOUBLE_EQ(*velocity.velocity_north_mps, 1.5);
  EXPECT_DOUBLE_EQ(*velocity.velocity_east_mps, -0.25);
  EXPECT_DOUBLE_EQ(*velocity.velocity_down_mps, -0.04);
  EXPECT_DOUBLE_EQ(*velocity.ground_speed_mps, 1.52);
  EXPECT_NEAR(degrees(*velocity.course_rad), 350.53778, 1e-9);
  EXPECT_DOUBLE_EQ(*velocity.speed_accuracy_mps, 0.35);
  const auto status = golden<NavStatus>();
  EXPECT_EQ(status.fix_type, UbxFixType::three_d);
  EXPECT_TRUE(status.fix_ok && status.week_known && status.time_known);
  EXPECT_DOUBLE_EQ(status.time_to_first_fix_s, 29.5);
  EXPECT_DOUBLE_EQ(status.uptime_s, 3600.25);
}

TEST(UbxSolution, APositionOrVelocityOfUnknownAccuracyIsNone) {
  Buffer payload(28, 0x01);
  for (std::size_t i = 20; i < 24; ++i) payload[i] = 0xFF;
  NavPosllh position;
  ASSERT_TRUE(read(payload, position));
  EXPECT_FALSE(position.latitude_rad || position.ellipsoidal_height_m);
  payload.assign(36, 0x01);
  for (std::size_t i = 28; i < 32; ++i) payload[i] = 0xFF;
  NavVelned velocity;
  ASSERT_TRUE(read(payload, velocity));
  EXPECT_FALSE(velocity.velocity_north_mps || velocity.ground_speed_mps || velocity.course_rad);
}

TEST(UbxSolution, DilutionsAreThoseThatGpsdReads) {
  const auto m = golden<NavDop>();
  EXPECT_DOUBLE_EQ(*m.geometric, 2.13);
  EXPECT_DOUBLE_EQ(*m.position, 1.87);
  EXPECT_DOUBLE_EQ(*m.time, 1.02);
  EXPECT_DOUBLE_EQ(*m.vertical, 1.59);
  EXPECT_DOUBLE_EQ(*m.horizontal, 0.98);
  EXPECT_DOUBLE_EQ(*m.north, 0.71);
  EXPECT_FALSE(m.east) << "99.99 is none";
}

TEST(UbxSolution, TimeIsKnownOnlyAsFarAsTheReceiverSays) {
  const auto gps = golden<NavTimeGps>();
  EXPECT_EQ(gps.gps_week, 1916);
  EXPECT_EQ(gps.leap_seconds, 17);
  const auto utc = golden<NavTimeUtc>();
  EXPECT_EQ(*utc.date, std::chrono::year{2016} / 9 / 26);
  EXPECT_EQ(*utc.time_of_day, 8h + 13min + 20s - 123456ns);

  Buffer payload(16, 0x10);
  payload[11] = 0x03;  // time and week, but not yet leap seconds: the value is firmware's default
  NavTimeGps before;
  ASSERT_TRUE(read(payload, before));
  EXPECT_TRUE(before.gps_week && !before.leap_seconds);
  payload.assign(20, 0x08);
  payload[19] = 0x03;
  NavTimeUtc unsure;
  ASSERT_TRUE(read(payload, unsure));
  EXPECT_FALSE(unsure.date || unsure.time_of_day);
}

template <class M>
bool takes(std::size_t size) {
  M m;
  return read(Buffer(size, 0), m);
}

TEST(UbxSolution, APayloadOfAnotherLengthIsRefused) {
  EXPECT_TRUE(takes<NavSol>(52) && takes<NavStatus>(16) && takes<NavPosllh>(28) &&
              takes<NavVelned>(36) && takes<NavDop>(18) && takes<NavTimeGps>(16) &&
              takes<NavTimeUtc>(20));
  EXPECT_FALSE(takes<NavSol>(51) || takes<NavStatus>(15) || takes<NavPosllh>(29) ||
               takes<NavVelned>(0) || takes<NavDop>(17) || takes<NavTimeGps>(20) ||
               takes<NavTimeUtc>(16));
}

}  // namespace ubx_solution_test
}  // namespace drydock::wire::testing
