// How far a vehicle goes down after its last fix, against the closed form of its motion.
#include "estimators/consistency/consistency.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "tests/estimators/consistency/voyage.hpp"

namespace drydock::consistency::test {
namespace {

using namespace measurement;
using diagnosis::Antenna;

/// A receiver (0) at 5 Hz, a DVL (1) at 5 Hz and an inertial unit (2) at 100 Hz. The vehicle makes
/// 2 m/s on a sea with waves of 0.2 m in 6 s; after 100 s its last fix.
struct Craft {
  static constexpr double last_fix_s = 100;

  Craft() {
    noise = [this](double sigma) { return sigma * normal(random); };
  }
  void run(double end_s) {
    for (; static_cast<double>(step) * 0.01 < end_s; ++step) tick(static_cast<double>(step) * 0.01);
  }
  void tick(double t) {
    const double since = t - last_fix_s;
    const double sinks = since > 0 && since < for_s ? sinking_mps : 0;
    constexpr double pace = 2 * std::numbers::pi / 6;
    const double down = sinks + 0.2 * pace * std::cos(pace * t);
    const double heave = -0.2 * pace * pace * std::sin(pace * t);
    ImuSample inertial;
    inertial.specific_force = {noise(0.01), noise(0.01), heave - 9.80665 + noise(0.01)};
    inertial.angular_rate = {noise(1e-4), noise(1e-4), noise(1e-4)};
    give(inertial, 2, t);
    if (step % 20 != 0) return;
    BottomVelocity bottom;
    if (has_dvl)
      bottom.velocity = Eigen::Vector3d{2 + noise(0.01), noise(0.01), down + noise(0.01)};
    give(bottom, 1, t);
    GnssFix fix;
    if (since <= 0) {
      fix.velocity_ned = Eigen::Vector3d{speed_mps, noise(0.05), noise(0.05)};
      fix.position = Geodetic{speed_mps * t / 6.371e6, 0};
    }
    give(fix, 0, t);
  }
  template <class Sample>
  void give(Sample sample, std::uint16_t device, double t) {
    sample.origin.device = device;
    sample.origin.valid_at = sample.origin.received_at = Stamp{} + from_seconds(1000 + t);
    checks.take(sample);
  }
  Antenna antenna_after(double seconds) {
    run(last_fix_s + seconds);
    return checks.antenna(0);
  }

  double sinking_mps = 0, for_s = 1e9, speed_mps = 2;
  bool has_dvl = true;
  long step = 0;
  std::mt19937_64 random{5};
  std::normal_distribution<double> normal;
  std::function<double(double)> noise;
  Signs signs;
  Consistency checks{{{.kind = Kind::gnss, .rate_hz = 5},
                      {.kind = Kind::dvl, .rate_hz = 5},
                      {.kind = Kind::imu, .rate_hz = 100}},
                     signs};
};

TEST(Dives, AreNotToldBeforeTenSecondsWithoutAFix) {
  Craft craft;
  EXPECT_EQ(craft.antenna_after(-1), Antenna::unknown);
  EXPECT_EQ(craft.antenna_after(9), Antenna::unknown);
}

TEST(Dives, OfOneMetreInTenSecondsTakeTheAntennaUnderWater) {
  Craft craft;
  craft.sinking_mps = 0.1;
  craft.for_s = 10;
  EXPECT_EQ(craft.antenna_after(13), Antenna::wet);
  EXPECT_EQ(craft.antenna_after(300), Antenna::wet) << "until the next fix";
}

TEST(Dives, AreNoneWhereTheVehicleStaysInTheWavesOfTheSurface) {
  Craft craft;
  EXPECT_EQ(craft.antenna_after(13), Antenna::dry);
  EXPECT_EQ(craft.antenna_after(600), Antenna::dry);
}

TEST(Dives, BeginLaterWithAReceiverThatWasBlindBefore) {
  Craft craft;
  EXPECT_EQ(craft.antenna_after(15), Antenna::dry);
  craft.sinking_mps = 0.5;
  EXPECT_EQ(craft.antenna_after(25), Antenna::wet);
}

TEST(Dives, AreUnknownWithoutAVelocityDown) {
  Craft craft;
  craft.has_dvl = false;
  EXPECT_EQ(craft.antenna_after(60), Antenna::unknown);
}

TEST(Dives, AreNothingThatATrainDoes) {
  Craft craft;
  craft.has_dvl = false;
  craft.speed_mps = 40;
  EXPECT_EQ(craft.antenna_after(3), Antenna::dry);
}

}  // namespace
}  // namespace drydock::consistency::test
