#include "estimators/consistency/consistency.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/estimators/consistency/faults_from.hpp"
#include "tests/estimators/pipeline/counting_new.hpp"

namespace drydock::consistency::test {
namespace {

using namespace measurement;
using diagnosis::Sign;

TEST(Consistency, SaysNothingOfAHealthyVehicleForAnHourWithEachOfThreeSeeds) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    Voyage voyage({dvl, log, gnss, imu, depth, actuators, compass}, seed);
    voyage.run(3600);
    EXPECT_EQ(voyage.said().size(), 0U) << "seed " << seed;
  }
}

TEST(Consistency, SaysNothingOfAnyTwoHealthySensors) {
  for (std::uint16_t a = 0; a < devices; ++a)
    for (std::uint16_t b = 0; b < a; ++b) {
      Voyage voyage({a, b});
      voyage.run(200);
      EXPECT_EQ(voyage.said().size(), 0U) << a << " with " << b;
    }
}

struct Case {
  const char* name;
  std::uint16_t device;
  Sign sign;
  double within_s;
  Voyage::Fault fault;
};

const Case cases[] = {
    {"ADvlThatReadsTooMuch", dvl, Sign::offset, 4,
     on<BottomVelocity>([](auto& m, double) { m.velocity->x() += 0.3; })},
    {"ADvlThatDriftsAway", dvl, Sign::ramp, 12,
     on<BottomVelocity>([](auto& m, double t) { m.velocity->x() += 0.02 * t; })},
    {"ALogThatReadsTooMuch", log, Sign::offset, 5,
     on<WaterSpeed>([](auto& m, double) { *m.longitudinal_mps += 0.5; })},
    {"AGnssVelocityThatReadsTooMuch", gnss, Sign::offset, 4,
     on<GnssFix>([](auto& m, double) { m.velocity_ned->x() += 1; })},
    {"AGnssPositionThatJumped", gnss, Sign::offset, 5,
     on<GnssFix>([](auto& m, double) { m.position->latitude_rad += 30 / 6.371e6; })},
    {"AGnssPositionThatDriftsAway", gnss, Sign::ramp, 10,
     on<GnssFix>([](auto& m, double t) { m.position->latitude_rad += 1.5 * t / 6.371e6; })},
    {"AGyroAboutTheVerticalWithABias", imu, Sign::offset, 6,
     on<ImuSample>([](auto& m, double) { m.angular_rate.z() += 1 * degree; })},
    {"AGyroAboutAheadWithABias", imu, Sign::offset, 6,
     on<ImuSample>([](auto& m, double) { m.angular_rate.x() += 1 * degree; })},
    {"AnAccelerometerWithABias", imu, Sign::offset, 4,
     on<ImuSample>([](auto& m, double) { m.specific_force.x() += 0.5; })},
    {"ARudderThatReadsTooMuch", actuators, Sign::offset, 5,
     on<ActuatorState>([](auto& m, double) { *m.rudder_rad += 5 * degree; })},
    // The law has learned for 20 s only: the hull may as well gain its speed slowly.
    {"AShaftThatReadsTooMuch", actuators, Sign::ramp, 12,
     on<ActuatorState>([](auto& m, double) { *m.propeller_radps += 10.5; })},
    {"ACompassThatTurned", compass, Sign::offset, 5, on<AttitudeSample>([](auto& m, double) {
       m.true_heading_rad = std::fmod(*m.true_heading_rad + 5 * degree, 2 * std::numbers::pi);
     })},
    {"ARollThatReadsTooMuch", compass, Sign::offset, 5,
     on<AttitudeSample>([](auto& m, double) { *m.roll_rad += 5 * degree; })},
};

class AFault : public testing::TestWithParam<Case> {};

TEST_P(AFault, IsLaidToItsDevice) {
  Voyage voyage;
  voyage.run(100, GetParam().fault);
  ASSERT_FALSE(voyage.said().empty());
  EXPECT_GT(voyage.said().front().at_s, begin_s);
  EXPECT_LT(voyage.said().front().at_s, begin_s + GetParam().within_s);
  std::size_t right = 0, said = 0;
  for (const auto& one : voyage.said()) {
    EXPECT_EQ(one.device, GetParam().device) << to_string(one.sign) << " at " << one.at_s;
    if (one.at_s > 92) continue;
    ++said;
    right += one.sign == GetParam().sign ? 1 : 0;
  }
  std::string signs;
  for (const auto& one : voyage.said())
    signs += std::string(to_string(one.sign)) + (one.at_s < 75 ? "," : ".");
  EXPECT_GT(2 * right, said) << signs;
}
INSTANTIATE_TEST_SUITE_P(Consistency, AFault, testing::ValuesIn(cases),
                         [](const auto& given) { return std::string(given.param.name); });

/// From the first sample on: no change shows it.
Voyage::Fault always(const std::function<void(BottomVelocity&)>& change) {
  return [change](Measurement& measurement, double) {
    if (auto* bottom = std::get_if<BottomVelocity>(&measurement)) change(*bottom);
  };
}

void expect_only(const Voyage& voyage, std::uint16_t device, Sign sign, double within_s) {
  ASSERT_FALSE(voyage.said().empty());
  EXPECT_LT(voyage.said().front().at_s, within_s);
  for (const auto& one : voyage.said()) {
    EXPECT_EQ(one.device, device) << one.at_s;
    EXPECT_EQ(one.sign, sign) << to_string(one.sign) << " at " << one.at_s;
  }
}

TEST(Consistency, SeesADvlThatIsMountedFourDegreesBowUpAgainstTheDepth) {
  Voyage voyage({dvl, imu, depth});
  voyage.run(400, always([](auto& m) {
               const double down = 2 * std::sin(4 * degree);
               m.velocity->z() += down;
             }));
  expect_only(voyage, dvl, Sign::rotated, 180);
}

TEST(Consistency, SeesADvlWhoseScaleIsFivePercentTooSmallFromTheStart) {
  Voyage voyage({dvl, gnss, imu});
  voyage.run(400, always([](auto& m) { m.velocity->x() *= 0.95; }));
  expect_only(voyage, dvl, Sign::scale, 180);
}

TEST(Consistency, SaysNothingOfAMountingOfOneDegreeOrAScaleOfOnePercent) {
  Voyage voyage({dvl, gnss, imu, depth});
  voyage.run(1000, always([](auto& m) {
               m.velocity->z() += 2 * std::sin(1 * degree);
               m.velocity->x() *= 0.99;
             }));
  EXPECT_EQ(voyage.said().size(), 0U);
}

const Case smallest[] = {
    {"Dvl", dvl, {}, 20, on<BottomVelocity>([](auto& m, double) { m.velocity->x() += 0.07; })},
    {"Log", log, {}, 20, on<WaterSpeed>([](auto& m, double) { *m.longitudinal_mps += 0.25; })},
    {"GnssVelocity", gnss, {}, 20, on<GnssFix>([](auto& m, double) {
       *m.velocity_ned *= 1 + 0.15 / 2;
     })},
    {"GnssPosition", gnss, {}, 20, on<GnssFix>([](auto& m, double) {
       m.position->latitude_rad += 6 / 6.371e6;
     })},
    {"Gyro", imu, {}, 20, on<ImuSample>([](auto& m, double) {
       m.angular_rate.y() += 0.3 * degree;
     })},
    {"Accelerometer", imu, {}, 20, on<ImuSample>([](auto& m, double) {
       m.specific_force.z() += 0.15;
     })},
    {"Depth", depth, {}, 20, on<DepthSample>([](auto& m, double) { *m.depth_m += 0.35; })},
    {"Rudder", actuators, {}, 20, on<ActuatorState>([](auto& m, double) {
       *m.rudder_rad += 3 * degree;
     })},
    {"Shaft", actuators, {}, 20, on<ActuatorState>([](auto& m, double) {
       *m.propeller_radps += 100 * std::numbers::pi / 30;
     })},
    {"Compass", compass, {}, 20, on<AttitudeSample>([](auto& m, double) {
       m.true_heading_rad = std::fmod(*m.true_heading_rad + 2 * degree, 2 * std::numbers::pi);
     })},
};

class TheSmallestFaultOfThePage : public testing::TestWithParam<Case> {};

TEST_P(TheSmallestFaultOfThePage, IsLaidToItsDeviceWithinTwentySeconds) {
  Voyage voyage;
  voyage.run(begin_s + GetParam().within_s, GetParam().fault);
  ASSERT_FALSE(voyage.said().empty());
  for (const auto& one : voyage.said()) EXPECT_EQ(one.device, GetParam().device) << one.at_s;
}
INSTANTIATE_TEST_SUITE_P(Consistency, TheSmallestFaultOfThePage, testing::ValuesIn(smallest),
                         [](const auto& given) { return std::string(given.param.name); });

/// The vehicle swings on: the rudder that it needs goes to 16 degrees and back.
TEST(Consistency, SeesARudderThatIsSaidToStandStillWhileTheVehicleTurns) {
  Voyage voyage;
  std::optional<double> last;
  voyage.run(100, on<ActuatorState>([&](auto& m, double) {
               if (!last) last = m.rudder_rad;
               m.rudder_rad = last;
             }));
  ASSERT_FALSE(voyage.said().empty());
  EXPECT_LT(voyage.said().front().at_s, begin_s + 12);
  for (const auto& one : voyage.said()) EXPECT_EQ(one.device, actuators) << one.at_s;
}

// A DVL jumps by 0.3 m/s between two samples; the log's own samples go on as before.
TEST(Consistency, OfTwoSensorsNamesTheOneThatJumped) {
  Voyage voyage({dvl, log, imu});
  voyage.run(100, on<BottomVelocity>([](auto& m, double) { m.velocity->x() += 0.6; }));
  ASSERT_FALSE(voyage.said().empty());
  for (const auto& one : voyage.said()) EXPECT_EQ(one.device, dvl);
}

TEST(Consistency, BearsValuesThatAreNoNumbersAndTimesThatGoBack) {
  Voyage voyage;
  voyage.run(80);
  voyage.run(81, [](Measurement& measurement, double) {
    if (auto* bottom = std::get_if<BottomVelocity>(&measurement))
      bottom->velocity->x() = std::numeric_limits<double>::quiet_NaN();
    if (auto* inertial = std::get_if<ImuSample>(&measurement))
      inertial->angular_rate.x() = std::numeric_limits<double>::infinity();
    if (auto* below = std::get_if<DepthSample>(&measurement))
      below->origin.valid_at -= std::chrono::hours{1};
  });
  voyage.run(400);
  for (const auto& one : voyage.said()) EXPECT_LT(one.at_s, 100);
  voyage.run(430, [](Measurement& measurement, double t) {
    if (auto* bottom = std::get_if<BottomVelocity>(&measurement); bottom && t > 410)
      bottom->velocity->x() += 0.3;
  });
  ASSERT_FALSE(voyage.said().empty());
  EXPECT_EQ(voyage.said().back().device, dvl);
  EXPECT_GT(voyage.said().back().at_s, 420);
}

TEST(Consistency, AllocatesNothingASampleOfAnyKind) {
  Voyage voyage;
  voyage.run(1);
  const std::size_t before = pipeline::test::allocations();
  voyage.run(120);
  EXPECT_EQ(pipeline::test::allocations(), before);
}

/// Counts what is said and keeps nothing.
class Count final : public diagnosis::SymptomSink {
 public:
  void see(const diagnosis::Symptom&) override { ++said; }
  int said = 0;
};

TEST(Consistency, AllocatesNothingASample) {
  Count count;
  const std::vector<Sensor> sensors{{.kind = Kind::dvl, .rate_hz = 5},
                                    {.kind = Kind::imu, .rate_hz = 100}};
  Consistency checks(sensors, count);
  const std::size_t before = pipeline::test::allocations();
  for (int i = 0; i < 20'000; ++i) {
    ImuSample inertial;
    inertial.origin.device = 1;
    inertial.origin.valid_at = inertial.origin.received_at = stamp_from_ns(10'000'000L * i);
    inertial.specific_force = {i > 10'000 ? 1.0 : 0.0, 0, -9.8};
    checks.take(inertial);
    if (i % 20 != 0) continue;
    BottomVelocity bottom;
    bottom.origin.valid_at = bottom.origin.received_at = inertial.origin.valid_at;
    bottom.velocity = Eigen::Vector3d{1, 0, 0};
    checks.take(bottom);
    checks.tell(bottom.origin.received_at);
  }
  EXPECT_GT(count.said, 100);
  EXPECT_EQ(pipeline::test::allocations(), before);
}

}  // namespace
}  // namespace drydock::consistency::test
