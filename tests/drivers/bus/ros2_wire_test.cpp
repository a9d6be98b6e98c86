#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "tests/drivers/bus/wire_reader.hpp"

namespace drydock::bus::test {
namespace {

using namespace measurement;
using testing::Each;
using testing::ElementsAre;
using testing::IsNan;

void expect_header(CdrReader& cdr, const std::string& frame) {
  EXPECT_EQ(cdr.next<std::int32_t>(), 1'700'000'000);
  EXPECT_EQ(cdr.next<std::uint32_t>(), 123'456'789u);
  EXPECT_EQ(cdr.next_string(), frame);
}

TEST(BusOnTheWire, ImuIsForwardLeftUpWithoutOrientation) {
  Wire<ImuMessage> wire("rt/imu/data");
  auto cdr = wire.publish(Measurement{ImuSample{origin(imu), {0.5, -0.25, -9.81}, {1, 2, 3}}});
  EXPECT_EQ(cdr.size(), 324u);
  expect_header(cdr, "imu_link");
  EXPECT_THAT(cdr.next_doubles(4), ElementsAre(0, 0, 0, 1));
  EXPECT_THAT(cdr.next_doubles(9), ElementsAre(-1, 0, 0, 0, 0, 0, 0, 0, 0));
  EXPECT_THAT(cdr.next_doubles(3), ElementsAre(1, -2, -3));
  EXPECT_THAT(cdr.next_doubles(9), Each(0));
  EXPECT_THAT(cdr.next_doubles(3), ElementsAre(0.5, 0.25, 9.81));
  EXPECT_THAT(cdr.next_doubles(9), Each(0));
}

TEST(BusOnTheWire, DvlKeepsItsForwardStarboardDownAxes) {
  Wire<DvlMessage> wire("rt/dvl/data");
  auto sample = only_origin<BottomVelocity>(dvl);
  sample.velocity = Eigen::Vector3d(1.5, 0.1, -0.2);
  sample.altitude_m = 12.5;
  sample.range_m = {12, 12.25, std::nullopt, 13};
  sample.sound_speed_mps = 1500;
  auto cdr = wire.publish(Measurement{sample});
  EXPECT_EQ(cdr.size(),
            364u);  // 356 with frame "base_link"; three more letters cross one alignment
  expect_header(cdr, "dvl_link_frd");
  EXPECT_EQ(cdr.next<std::uint8_t>(), 1);  // DVL_MODE_BOTTOM
  EXPECT_EQ(cdr.next<std::uint8_t>(), 0);
  EXPECT_THAT(cdr.next_doubles(3), ElementsAre(1.5, 0.1, -0.2));
  EXPECT_THAT(cdr.next_doubles(9), Each(-1));
  EXPECT_EQ(cdr.next<double>(), 12.5);
  EXPECT_DOUBLE_EQ(cdr.next<double>(), std::atan2(0.1, 1.5));
  EXPECT_DOUBLE_EQ(cdr.next<double>(), std::sqrt(1.5 * 1.5 + 0.1 * 0.1));
  EXPECT_EQ(cdr.next<std::uint8_t>(), 3);  // good beams
  EXPECT_EQ(cdr.next<float>(), 1500.0f);
  EXPECT_EQ(cdr.next<std::uint8_t>(), 0);  // no ranges along the beams
  EXPECT_EQ(cdr.next<std::uint8_t>(), 0);  // no velocities along the beams
  EXPECT_THAT(cdr.next_doubles(12), Each(IsNan()));
  EXPECT_THAT(cdr.next_doubles(4), Each(IsNan()));
}

TEST(BusOnTheWire, WaterSpeedIsATwistWhoseUnmeasuredComponentsHaveVarianceMinusOne) {
  Wire<TwistMessage> wire("rt/log/twist");
  auto cdr = wire.publish(Measurement{WaterSpeed{origin(log), 2.0, std::nullopt, 7.0, {}}});
  EXPECT_EQ(cdr.size(), 364u);
  expect_header(cdr, "log_link");
  EXPECT_THAT(cdr.next_doubles(6), ElementsAre(2, 0, 0, 0, 0, 0));
  const auto covariance = cdr.next_doubles(36);
  EXPECT_EQ(covariance[0], 1e6) << "0 would say that the speed is exact";
  for (std::size_t i = 1; i < 6; ++i) EXPECT_EQ(covariance[7 * i], -1);
}

TEST(BusOnTheWire, TwistOfTheDvlIsForwardLeftUp) {
  Wire<TwistMessage> wire("rt/dvl/twist");
  auto sample = only_origin<BottomVelocity>(dvl);
  sample.velocity = Eigen::Vector3d(1.5, 0.1, -0.2);
  auto cdr = wire.publish(Measurement{sample});
  EXPECT_EQ(cdr.size(), 364u);
  expect_header(cdr, "dvl_link");
  EXPECT_THAT(cdr.next_doubles(3), ElementsAre(1.5, -0.1, 0.2));
}

/// The covariance of (x, y, z) in forward, starboard, down; to port and up, xy and xz change sign.
TEST(BusOnTheWire, TheCovarianceOfTheDvlTurnsWithItsVelocity) {
  Wire<TwistMessage> wire("rt/dvl/twist");
  auto sample = only_origin<BottomVelocity>(dvl);
  sample.velocity = Eigen::Vector3d(1.5, 0.1, -0.2);
  sample.velocity_covariance = Eigen::Matrix3d{{4, 0.5, 0.25}, {0.5, 9, 0.125}, {0.25, 0.125, 16}};
  auto cdr = wire.publish(Measurement{sample});
  expect_header(cdr, "dvl_link");
  cdr.next_doubles(6);
  EXPECT_THAT(cdr.next_doubles(3), ElementsAre(4, -0.5, -0.25));
  cdr.next_doubles(3);
  EXPECT_THAT(cdr.next_doubles(3), ElementsAre(-0.5, 9, 0.125));
  cdr.next_doubles(3);
  EXPECT_THAT(cdr.next_doubles(3), ElementsAre(-0.25, 0.125, 16));
}

TEST(BusOnTheWire, GnssVelocityIsEastNorthUp) {
  Wire<TwistMessage> wire("rt/gps/velocity");
  auto sample = only_origin<GnssFix>(gnss);
  sample.velocity_ned = Eigen::Vector3d(1, 2, 3);
  sample.speed_accuracy_mps = 0.5;
  auto cdr = wire.publish(Measurement{sample});
  expect_header(cdr, "gps_enu");
  EXPECT_THAT(cdr.next_doubles(3), ElementsAre(2, 1, -3));
  cdr.next_doubles(3);
  EXPECT_EQ(cdr.next<double>(), 0.25);
}

TEST(BusOnTheWire, SpeedAndCourseAreAnEastNorthVelocityWithoutUp) {
  Wire<TwistMessage> wire("rt/gps/velocity");
  auto sample = only_origin<GnssFix>(gnss);
  sample.ground_speed_mps = 2;
  sample.course_rad = std::numbers::pi / 6;
  auto cdr = wire.publish(Measurement{sample});
  expect_header(cdr, "gps_enu");
  EXPECT_NEAR(cdr.next<double>(), 1, 1e-12);
  EXPECT_NEAR(cdr.next<double>(), std::sqrt(3), 1e-12);
  EXPECT_EQ(cdr.next<double>(), 0);
  cdr.next_doubles(3);
  const auto covariance = cdr.next_doubles(36);
  EXPECT_EQ(covariance[7], 1e6);
  EXPECT_EQ(covariance[14], -1);
}

TEST(BusOnTheWire, NavSatFixIsInDegreesAndWithoutAFixItIsNan) {
  Wire<NavSatFixMessage> wire("rt/gps/fix");
  auto sample = only_origin<GnssFix>(gnss);
  sample.position = Geodetic{std::numbers::pi / 4, -std::numbers::pi / 2};
  sample.ellipsoidal_height_m = -32.25;
  auto cdr = wire.publish(Measurement{sample});
  EXPECT_EQ(cdr.size(), 128u);
  expect_header(cdr, "gps_link");
  EXPECT_EQ(cdr.next<std::int8_t>(), 0);
  EXPECT_EQ(cdr.next<std::uint16_t>(), 0);
  EXPECT_THAT(cdr.next_doubles(3), ElementsAre(45, -90, -32.25));

  auto none = wire.publish(Measurement{only_origin<GnssFix>(gnss)});
  expect_header(none, "gps_link");
  EXPECT_EQ(none.next<std::int8_t>(), -1);
  none.next<std::uint16_t>();
  EXPECT_THAT(none.next_doubles(3), Each(IsNan()));
}

TEST(BusOnTheWire, PressureIsInPascalAndTemperatureInCelsius) {
  const DepthSample sample{origin(depth), 10.0, 201'325.5, 280.15, {}};
  auto pressure = Wire<FluidPressureMessage>("rt/ctd/pressure").publish(Measurement{sample});
  EXPECT_EQ(pressure.size(), 44u);
  expect_header(pressure, "ctd_link");
  EXPECT_EQ(pressure.next<double>(), 201'325.5);
  auto temperature = Wire<TemperatureMessage>("rt/ctd/temperature").publish(Measurement{sample});
  expect_header(temperature, "ctd_link");
  EXPECT_NEAR(temperature.next<double>(), 7.0, 1e-12);
}

TEST(BusOnTheWire, AttitudeIsAgainstEastNorthUp) {
  Wire<ImuMessage> wire("rt/estimate/leveling");
  const double half = std::sqrt(0.5), degree = std::numbers::pi / 180;
  const auto orientation = [&](double roll, double pitch, double yaw) {
    auto cdr = wire.publish(Attitude{origin(imu).valid_at, roll, pitch, yaw, {}}, std::size_t{0});
    expect_header(cdr, "base_link");
    return cdr.next_doubles(4);
  };
  const auto near = [](double x, double y, double z, double w) {
    return testing::Pointwise(testing::DoubleNear(1e-15), {x, y, z, w});
  };
  EXPECT_THAT(orientation(0, 0, 90 * degree), near(0, 0, 0, 1));  // bow east: x is east
  EXPECT_THAT(orientation(0, 0, 0), near(0, 0, half, half));      // bow north
  EXPECT_THAT(orientation(0, 30 * degree, 90 * degree),           // bow up: negative about left
              near(0, -std::sin(15 * degree), 0, std::cos(15 * degree)));
  EXPECT_THAT(orientation(20 * degree, 0, 90 * degree),  // starboard down
              near(std::sin(10 * degree), 0, 0, std::cos(10 * degree)));
}

TEST(BusOnTheWire, AttitudeSaysThatItHasNoRatesAndWhetherItHasYaw) {
  Wire<ImuMessage> wire("rt/estimate/leveling");
  Attitude attitude{origin(imu).valid_at, 0, 0, {}, {}};
  attitude.covariance << 1, 0.5, 0.5, 2;
  auto cdr = wire.publish(attitude, std::size_t{0});
  expect_header(cdr, "base_link");
  cdr.next_doubles(4);
  EXPECT_THAT(cdr.next_doubles(9), ElementsAre(1, -0.5, 0, -0.5, 2, 0, 0, 0, 1e6));
  cdr.next_doubles(3);
  EXPECT_EQ(cdr.next_doubles(9)[0], -1);
  cdr.next_doubles(3);
  EXPECT_EQ(cdr.next_doubles(9)[0], -1);
}

TEST(BusOnTheWire, HealthIsADiagnosticArray) {
  Wire<DiagnosticsMessage> wire("rt/diagnostics");
  const std::vector<DeviceStatus> health{
      {Level::warn, "dvl", "no bottom lock", "serial:/dev/ttyS0", {{"beams", "2"}}}};
  auto cdr = wire.publish(std::span(health), origin(dvl).valid_at);
  expect_header(cdr, "");
  EXPECT_EQ(cdr.next<std::uint32_t>(), 1u);
  EXPECT_EQ(cdr.next<std::uint8_t>(), 1);  // WARN
  EXPECT_EQ(cdr.next_string(), "dvl");
  EXPECT_EQ(cdr.next_string(), "no bottom lock");
  EXPECT_EQ(cdr.next_string(), "serial:/dev/ttyS0");
  EXPECT_EQ(cdr.next<std::uint32_t>(), 1u);
  EXPECT_EQ(cdr.next_string(), "beams");
  EXPECT_EQ(cdr.next_string(), "2");
}

}  // namespace
}  // namespace drydock::bus::test
