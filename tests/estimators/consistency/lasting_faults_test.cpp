// How long a finding lasts, who is named beside it, and two faults at once.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "tests/estimators/consistency/faults_from.hpp"

namespace drydock::consistency::test {
namespace {

using namespace measurement;
using diagnosis::Sign;

/// The finding lasts as long as the fault, and nobody else is named beside it.
void expect_only_the_unit_until(double end_s, const Voyage& voyage) {
  ASSERT_FALSE(voyage.said().empty());
  for (const auto& one : voyage.said())
    EXPECT_EQ(one.device, imu) << to_string(one.sign) << " at " << one.at_s;
  double silent_s = 0, last_s = voyage.said().front().at_s;
  for (const auto& one : voyage.said()) {
    silent_s = std::max(silent_s, one.at_s - last_s);
    last_s = one.at_s;
  }
  EXPECT_LT(silent_s, 10) << "then a finding ends";
  EXPECT_GT(last_s, end_s - 10);
}

TEST(Consistency, NamesAGyroAsLongAsItIsWrongAndNobodyElse) {
  Voyage voyage;
  voyage.run(300, on<ImuSample>([](auto& m, double) { m.angular_rate.z() += 0.5 * degree; }));
  expect_only_the_unit_until(300, voyage);
}

/// Its last rate of turn would turn the others away from it for ever.
TEST(Consistency, AccusesNobodyOfWhatAStuckUnitSays) {
  Voyage voyage;
  std::optional<ImuSample> last;
  voyage.run(300, on<ImuSample>([&](auto& m, double) {
               if (!last) last = m;
               m.angular_rate = last->angular_rate;
               m.specific_force = last->specific_force;
             }));
  for (const auto& one : voyage.said())
    EXPECT_EQ(one.device, imu) << to_string(one.sign) << " at " << one.at_s;
}

/// Its speed is as large as before: only the log tells that the vehicle goes ahead.
TEST(Consistency, NamesADvlWhoseAxesAreInvertedOrSwappedAndNeverTheLog) {
  const Voyage::Fault faults[] = {
      on<BottomVelocity>([](auto& m, double) { *m.velocity *= -1; }),
      on<BottomVelocity>([](auto& m, double) { std::swap(m.velocity->x(), m.velocity->y()); })};
  for (const auto& fault : faults) {
    Voyage voyage({dvl, log, gnss, imu, depth, actuators});
    voyage.run(200, fault);
    const auto says_of = [&](std::uint16_t device) {
      return std::ranges::count(voyage.said(), device, &Signs::Said::device);
    };
    EXPECT_GT(says_of(dvl), 400) << "about four a second";
    EXPECT_EQ(says_of(log) + says_of(depth), 0);
  }
}

TEST(Consistency, ForgetsAFaultThatIsOver) {
  Voyage voyage;
  voyage.run(90, on<BottomVelocity>([](auto& m, double) { m.velocity->x() += 0.3; }));
  voyage.run(200);
  ASSERT_FALSE(voyage.said().empty());
  EXPECT_LT(voyage.said().back().at_s, 100);
}

/// While the inertial unit is off the bow goes up by 8 degrees, and the vehicle climbs. All that is
/// measured later fits together, so nobody is wrong. A level that nothing had turned would say
/// 2 m/s * sin(8 deg) = 0.28 m/s to the DVL, and 1.4 m/s2 to the unit.
TEST(Consistency, DoubtsNothingWhenAnInertialUnitComesBackToAVehicleThatPitchedMeanwhile) {
  constexpr double off_s = 200, on_s = 226, most_rad = 8 * degree;
  double depth_m = 10;
  Voyage voyage({dvl, gnss, imu, depth});
  voyage.run(500, [&](Measurement& measurement, double t) {
    const double share = std::clamp((t - off_s - 5) / 10, 0.0, 1.0);
    const double pitch = most_rad * share, rate = share > 0 && share < 1 ? most_rad / 10 : 0;
    const Eigen::Matrix3d to_body =
        Eigen::AngleAxisd(-pitch, Eigen::Vector3d::UnitY()).toRotationMatrix();
    if (auto* inertial = std::get_if<ImuSample>(&measurement)) {
      const double speed = 2 + 0.1 * std::sin(2 * std::numbers::pi * t / 20);
      depth_m -= 0.01 * speed * std::tan(pitch);
      inertial->angular_rate = to_body * inertial->angular_rate + rate * Eigen::Vector3d::UnitY();
      inertial->specific_force = to_body * inertial->specific_force;
      if (t >= off_s && t < on_s) inertial->angular_rate.x() = std::nan("");  // not taken
    }
    if (auto* below = std::get_if<DepthSample>(&measurement)) *below->depth_m += depth_m - 10;
    if (auto* bottom = std::get_if<BottomVelocity>(&measurement)) {
      bottom->velocity->z() -= bottom->velocity->x() * std::tan(pitch);
      bottom->velocity = to_body * *bottom->velocity;
    }
  });
  for (const auto& one : voyage.said())
    EXPECT_TRUE(false) << one.at_s << " s: " << one.device << " " << diagnosis::to_string(one.sign);
}

TEST(Consistency, NamesTwoFaultsAtOnce) {
  Voyage voyage;
  voyage.run(100, [](Measurement& measurement, double t) {
    if (t < begin_s) return;
    if (auto* bottom = std::get_if<BottomVelocity>(&measurement)) bottom->velocity->x() += 0.5;
    if (auto* fix = std::get_if<GnssFix>(&measurement))
      fix->position->longitude_rad += 50 / 6.371e6;
  });
  bool of_dvl = false, of_gnss = false;
  for (const auto& one : voyage.said()) {
    of_dvl = of_dvl || one.device == dvl;
    of_gnss = of_gnss || one.device == gnss;
    EXPECT_TRUE(one.device == dvl || one.device == gnss);
  }
  EXPECT_TRUE(of_dvl && of_gnss);
}

}  // namespace
}  // namespace drydock::consistency::test
