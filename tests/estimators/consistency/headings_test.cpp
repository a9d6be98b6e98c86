#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "tests/estimators/consistency/voyage.hpp"

namespace drydock::consistency::test::headings_test {
namespace {

using namespace measurement;
using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180, gravity = 9.80665;

Matrix3d turned(double roll_deg, double pitch_deg, double yaw_deg) {
  return (AngleAxisd{yaw_deg * degree, Vector3d::UnitZ()} *
          AngleAxisd{pitch_deg * degree, Vector3d::UnitY()} *
          AngleAxisd{roll_deg * degree, Vector3d::UnitX()})
      .toRotationMatrix();
}

/// A vehicle at rest on one heading. Its pitch goes from 0 to 29 degrees in ten seconds, stays for
/// fifty, and goes back. A compass tells the heading of the bow.
class PitchingVehicle {
 public:
  explicit PitchingVehicle(const Matrix3d& mounting) : mounting_(mounting) {}

  bool with_tilts = true, with_imu = false;

  std::size_t findings(double end_s) {
    std::vector<Sensor> sensors{{.kind = Kind::dvl, .rate_hz = 5, .sensor_to_body = mounting_},
                                {.kind = Kind::attitude, .rate_hz = 10},
                                {.kind = Kind::imu, .rate_hz = 50}};
    Signs signs;
    Consistency checks(sensors, signs);
    for (int step = 0; step < static_cast<int>(50 * end_s); ++step) {
      const double t = step / 50.0;
      const auto give = [&](auto sample, std::uint16_t device) {
        sample.origin.device = device;
        sample.origin.valid_at = sample.origin.received_at = Stamp{} + from_seconds(1000 + t);
        checks.take(sample);
      };
      if (with_imu) give(inertial(t), 2);
      if (step % 5 == 0) give(compass(), 1);
      if (step % 10 == 0) give(head(t), 0);
      checks.tell(Stamp{} + from_seconds(t));
    }
    return signs.all.size();
  }

 private:
  static constexpr double heading_deg = 30, most_deg = 29;

  static double pitch_deg(double t) {
    const double in = std::fmod(t, 140);
    const auto ramp = [](double part) {
      return most_deg * (1 - std::cos(std::numbers::pi * part)) / 2;
    };
    return in < 30    ? 0
           : in < 40  ? ramp((in - 30) / 10)
           : in < 90  ? most_deg
           : in < 100 ? ramp((100 - in) / 10)
                      : 0;
  }
  static ImuSample inertial(double t) {
    ImuSample sample;
    const double h = 0.01;
    sample.angular_rate = {0, (pitch_deg(t + h) - pitch_deg(t - h)) / (2 * h) * degree, 0};
    sample.specific_force =
        turned(0, pitch_deg(t), heading_deg).transpose() * Vector3d{0, 0, -gravity};
    sample.specific_force.x() += 1e-6 * std::sin(1000 * t);  // one that repeats itself is stuck
    return sample;
  }
  static AttitudeSample compass() {
    AttitudeSample sample;
    sample.true_heading_rad = heading_deg * degree;
    return sample;
  }
  BottomVelocity head(double t) const {
    const Matrix3d axes = turned(0, pitch_deg(t), heading_deg) * mounting_;
    BottomVelocity sample;
    sample.velocity = Vector3d::Zero();
    sample.heading_rad = std::atan2(axes(1, 0), axes(0, 0));
    if (!with_tilts) return sample;
    sample.roll_rad = std::atan2(axes(2, 1), axes(2, 2));
    sample.pitch_rad = std::atan(-axes(2, 0) / std::abs(axes(2, 2)));  // of a gimbal
    return sample;
  }

  Matrix3d mounting_;
};

const Matrix3d mountings[] = {turned(0, 0, 45), turned(0, 0, -135), turned(10, -15, 60),
                              turned(0, 0, 0)};

TEST(Headings, AHeadThatIsMountedTurnedAgreesWithTheCompassOfAPitchingVehicle) {
  for (const Matrix3d& mounting : mountings)
    EXPECT_EQ(PitchingVehicle(mounting).findings(400), 0U) << mounting;
}

TEST(Headings, AHeadWithoutTiltsIsTurnedByTheLevelOfTheInertialUnit) {
  for (const Matrix3d& mounting : mountings) {
    PitchingVehicle vehicle(mounting);
    vehicle.with_tilts = false;
    vehicle.with_imu = true;
    EXPECT_EQ(vehicle.findings(400), 0U) << mounting;
  }
}

}  // namespace
}  // namespace drydock::consistency::test::headings_test
