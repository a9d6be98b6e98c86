#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/drivers/described/driven.hpp"

/// Sensors that say their attitude as a quaternion.
namespace drydock::described::test {
namespace quaternion_test {

using measurement::AttitudeSample;
using ::testing::HasSubstr;

constexpr double degree = emulate::degree;

/// A line of four numbers, named NAME_w to NAME_z.
DescriptionPtr four_numbers(const std::string& name) {
  return described(fmt::format(R"(
[sensor]
title = "AHRS"
kind = "attitude"
[protocol]
[[protocol.lines]]
name = "q"
head = "Q,"
fields = [
  {{ field = "{0}_w", decimals = 6 }},
  {{ field = "{0}_x", decimals = 6 }},
  {{ field = "{0}_y", decimals = 6 }},
  {{ field = "{0}_z", decimals = 6 }},
]
)",
                               name));
}

Heard heard_of(const std::string& name, const Eigen::Quaterniond& q) {
  Heard heard;
  receive(*driver_of(four_numbers(name)),
          fmt::format("Q,{:.9f},{:.9f},{:.9f},{:.9f}\r\n", q.w(), q.x(), q.y(), q.z()), {}, heard);
  return heard;
}

/// Roll, pitch and heading in degrees of the sentence with this quaternion.
Eigen::Vector3d angles_of(const std::string& name, const Eigen::Quaterniond& q) {
  const Heard heard = heard_of(name, q);
  const auto& sample = heard.last<AttitudeSample>();
  return Eigen::Vector3d(sample.roll_rad.value(), sample.pitch_rad.value(),
                         sample.true_heading_rad.value()) /
         degree;
}

Eigen::Quaterniond about(const Eigen::Vector3d& axis, double degrees) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(degrees * degree, axis));
}

const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                      z = Eigen::Vector3d::UnitZ();

void expect_near(const Eigen::Vector3d& angles, const Eigen::Vector3d& expected) {
  EXPECT_LT((angles - expected).norm(), 1e-5) << angles.transpose();
}

TEST(Quaternions, OfNorthEastDownTurnYawThenPitchThenRoll) {
  expect_near(angles_of("quaternion", about(z, 90)), {0, 0, 90});
  expect_near(angles_of("quaternion", about(y, 12)), {0, 12, 0});
  expect_near(angles_of("quaternion", about(z, 215) * about(y, 20) * about(x, -170)),
              {-170, 20, 215});
}

/// REP 103: a body at rest in its east-north-up axes looks east; its yaw counts against the
/// compass.
TEST(Quaternions, OfEastNorthUpLookEastAtRestAndTurnAgainstTheCompass) {
  expect_near(angles_of("enu_quaternion", Eigen::Quaterniond::Identity()), {0, 0, 90});
  expect_near(angles_of("enu_quaternion", about(z, 90)), {0, 0, 0});
  expect_near(angles_of("enu_quaternion", about(z, -30)), {0, 0, 120});
  expect_near(angles_of("enu_quaternion", about(y, 10)), {0, -10, 90});  // about port: bow down
  expect_near(angles_of("enu_quaternion", about(x, 10)), {10, 0, 90});
}

TEST(Quaternions, WithTheOtherSignAreTheSameAttitude) {
  const Eigen::Quaterniond turned = about(z, 300) * about(y, -5);
  const Eigen::Quaterniond other(-turned.w(), -turned.x(), -turned.y(), -turned.z());
  expect_near(angles_of("quaternion", other), {0, -5, 300});
}

TEST(Quaternions, WhoseLengthIsNotOneAreRefusedAndTold) {
  const Heard heard = heard_of("quaternion", Eigen::Quaterniond(0, 0, 0, 0));
  EXPECT_TRUE(heard.all.empty());
  ASSERT_EQ(heard.refusals.size(), 1u);
  EXPECT_THAT(heard.refusals[0], HasSubstr("quaternion whose length is not 1"));
  EXPECT_TRUE(heard_of("quaternion", Eigen::Quaterniond(0.9, 0, 0, 0)).all.empty());
}

// Under way: roll 3, pitch -4, heading 290 degrees.
TEST(Quaternions, OfAnEmulatedSensorAreTheAttitudeOfTheTruth) {
  for (const char* name : {"quaternion", "enu_quaternion"}) {
    Bench bench(four_numbers(name), 10);
    bench.run(2);
    ASSERT_GE(bench.all.size(), 18u) << name;
    const auto& last = std::get<AttitudeSample>(bench.all.back());
    EXPECT_NEAR(last.roll_rad.value() / degree, 3, 2e-4) << name;
    EXPECT_NEAR(last.pitch_rad.value() / degree, -4, 2e-4) << name;
    EXPECT_NEAR(last.true_heading_rad.value() / degree, 290, 2e-4) << name;
  }
}

TEST(WholeSamples, NeedEveryComponentOfAQuaternionAndOfAVelocity) {
  const auto problems = [](const char* kind, const char* first, const char* second) {
    return problems_of(
        fmt::format(R"(
[sensor]
title = "x"
kind = "{}"
[protocol]
[[protocol.lines]]
name = "m"
head = "M,"
fields = [{{ field = "{}"{} }}, {{ field = "{}"{} }}]
)",
                    kind, first, std::string_view(kind) == "dvl" ? R"(, unit = "m/s")" : "", second,
                    std::string_view(kind) == "dvl" ? R"(, unit = "m/s")" : ""));
  };
  EXPECT_THAT(
      problems("attitude", "quaternion_w", "quaternion_z"),
      HasSubstr("toy.toml:6:1: /protocol/lines/0: a quaternion has four components; this "
                "one lacks quaternion_x quaternion_y; messages with one 'sample' make one"));
  EXPECT_THAT(problems("dvl", "forward_mps", "starboard_mps"),
              HasSubstr("a velocity has three components; this one lacks down_mps"));
}

TEST(WholeSamples, OfFramesNeedTheForcesBesideTheRates) {
  EXPECT_THAT(problems_of(R"(
[sensor]
title = "x"
kind = "imu"
[protocol]
dbc = "xsens.dbc"
[[protocol.frames]]
message = "rate_of_turn"
fields = [
  { signal = "rate_x_degps", field = "rate_x_degps" },
  { signal = "rate_y_degps", field = "rate_y_degps" },
  { signal = "rate_z_degps", field = "rate_z_degps" },
]
)"),
              HasSubstr("this one lacks force_x_mps2 force_y_mps2 force_z_mps2"));
}

}  // namespace quaternion_test
}  // namespace drydock::described::test
