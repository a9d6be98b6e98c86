// A DVL that is late from its first sample on: while the vehicle brakes it reads too much by a
// constant, as one that is off does.
#include <gtest/gtest.h>

#include <deque>

#include "tests/estimators/consistency/faults_from.hpp"

namespace drydock::consistency::test {
namespace {

using namespace measurement;
using diagnosis::Sign;

const std::vector<std::uint16_t> all{dvl, log, gnss, imu, depth, compass};
const double brakes[] = {80, 83, 90, 95, 100, 110, 200};

/// Its samples are those of `periods` of 0.2 s ago.
Voyage::Fault late_by(std::size_t periods) {
  std::deque<Eigen::Vector3d> held;
  return from_the_start<BottomVelocity>([=](BottomVelocity& sample) mutable {
    held.push_back(*sample.velocity);
    if (held.size() > periods + 1) held.pop_front();
    sample.velocity = held.front();
  });
}

TEST(LateDvl, IsCalledLateAndNeverOffWhenTheVehicleBrakes) {
  for (const auto& with : {all, {dvl, log, imu}, {dvl, gnss, imu}, {dvl, gnss}, {dvl, log}})
    for (const std::size_t periods : {2UL, 3UL, 5UL})
      for (const double brake_s : brakes) {
        Voyage voyage(with);
        voyage.brake_at(brake_s);
        voyage.run(300, late_by(periods));
        for (const auto& one : voyage.said()) {
          EXPECT_EQ(one.sign, Sign::delayed) << periods << " periods, brakes at " << brake_s;
          EXPECT_EQ(one.device, dvl) << to_string(one.sign) << " at " << one.at_s;
        }
        if (with.size() == all.size() && periods == 5) EXPECT_FALSE(voyage.said().empty());
      }
}

TEST(LateDvl, IsNoneThatReadsTooMuchFromTheBrakingOn) {
  for (const double brake_s : brakes) {
    Voyage voyage(all);
    voyage.brake_at(brake_s);
    voyage.run(300, [&](Measurement& measurement, double t) {
      auto* sample = std::get_if<BottomVelocity>(&measurement);
      if (sample != nullptr && t > brake_s) sample->velocity->x() += 0.3;
    });
    ASSERT_FALSE(voyage.said().empty());
    EXPECT_LT(voyage.said().front().at_s, brake_s + 8) << "some seconds behind the manoeuvre";
    for (const auto& one : voyage.said()) {
      EXPECT_EQ(one.device, dvl) << one.at_s;
      EXPECT_EQ(one.sign, Sign::offset) << to_string(one.sign) << " at " << one.at_s;
    }
  }
}

/// 0.05 m/s of a receiver turn a course of 1 m/s by 3 degrees, and one of 2 m/s by half of it.
TEST(Consistency, SaysNothingOfAHealthyVehicleThatBrakesToHalfItsSpeed) {
  for (unsigned seed = 1; seed <= 5; ++seed)
    for (const double brake_s : brakes) {
      Voyage voyage(all, seed);
      voyage.brake_at(brake_s);
      voyage.run(300);
      EXPECT_TRUE(voyage.said().empty()) << "seed " << seed << ", brakes at " << brake_s;
    }
}

}  // namespace
}  // namespace drydock::consistency::test
