#include "hil/sensor/ideal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "estimators/frame/attitude.hpp"
#include "estimators/frame/geodetic.hpp"
#include "hil/sensor/sky.hpp"
#include "tests/hil/frozen.hpp"

namespace drydock::sensor {
namespace {

using Eigen::Vector3d;
using measurement::stamp_from_ns;

constexpr double degree = std::numbers::pi / 180;

// Spins about z at a rate that grows linearly: rate = w0 + acceleration * t. Without gravity and
// Earth rate.
class Spin final : public Trajectory {
 public:
  Spin(double rate, double acceleration) : rate_(rate), acceleration_(acceleration) {}
  Truth at(Stamp time) const override {
    Truth truth;
    truth.at = time;
    truth.rate_body.z() = rate_ + acceleration_ * measurement::seconds(time.time_since_epoch());
    truth.angular_rate = truth.rate_body;
    return truth;
  }
  Stamp start() const override { return stamp_from_ns(0); }
  Stamp end() const override { return stamp_from_ns(0); }

 private:
  double rate_, acceleration_;
};

Truth level(double depth = 10, double bed = 60) {
  Truth truth;
  truth.latitude_rad = 45 * degree;
  truth.height_m = -depth;
  truth.bed_depth_m = bed;
  truth.velocity_body = truth.velocity_ned = {2, 0, 0};
  return truth;
}

void set_attitude(Truth& truth, double roll, double pitch, double yaw) {
  truth.body_to_ned = frame::body_to_ned({roll, pitch, yaw});
  truth.velocity_ned = truth.body_to_ned * truth.velocity_body;
}

TEST(IdealImu, AheadOfTheAxisOfRotationItFeelsCentripetalAndTangentialForce) {
  const Spin spin(0.5, 0.1);
  const Mounting mounting{Eigen::Matrix3d::Identity(), {2, 0, 0}};
  const auto sample = ideal_imu(spin, stamp_from_ns(3'000'000'000), mounting);
  const double w = 0.8;
  EXPECT_NEAR(sample.specific_force.x(), -w * w * 2, 1e-12);
  EXPECT_NEAR(sample.specific_force.y(), 0.1 * 2, 1e-9);
  EXPECT_NEAR(sample.specific_force.z(), 0, 1e-12);
}

TEST(IdealImu, TurnedAQuarterToStarboardItsXAxisIsTheVehiclesY) {
  rig_config::DeviceConfig config;
  config.mounting_rad = {0, 0, 90 * degree};
  config.lever_arm_m = {2, 0, 0};
  const Spin spin(0.8, 0);
  const auto sample = ideal_imu(spin, stamp_from_ns(0), mounting_of(config));
  EXPECT_NEAR(sample.specific_force.x(), 0, 1e-12);
  EXPECT_NEAR(sample.specific_force.y(), 0.8 * 0.8 * 2, 1e-12);
  EXPECT_NEAR(sample.angular_rate.z(), 0.8, 1e-12);
}

TEST(LeverArm, TurningAboutZTheSensorAheadMovesToStarboard) {
  Truth truth = level();
  truth.rate_body = {0, 0, 0.1};
  const Vector3d v = velocity_at(truth, {Eigen::Matrix3d::Identity(), {5, 0, 0}});
  EXPECT_NEAR((v - Vector3d(2, 0.5, 0)).norm(), 0, 1e-12);
}

TEST(IdealLog, ReadsTheSpeedThroughTheWaterNotOverTheGround) {
  Truth truth = level();
  set_attitude(truth, 0, 0, 90 * degree);  // heading east at 2 m/s over ground
  truth.current_ned = {0.3, 0.5, 0};       // a current along the course and to port
  const auto sample = ideal_log(motion::test::Frozen(truth), {}, {});
  EXPECT_NEAR(*sample.longitudinal_mps, 1.5, 1e-12);
  EXPECT_NEAR(*sample.transverse_mps, 0.3, 1e-12);
}

TEST(IdealLog, FeelsTheCurrentAtItsOwnDepth) {
  rig_config::OceanConfig ocean;
  ocean.current = {{10, {0, 0, 0}}, {14, {1, 0, 0}}};
  const motion::test::Frozen trajectory(level(10), ocean);
  const auto sample = ideal_log(trajectory, {}, {Eigen::Matrix3d::Identity(), {0, 0, 2}});
  EXPECT_NEAR(*sample.longitudinal_mps, 2 - 0.5, 1e-12);
}

TEST(IdealGnss, TheAntennaStandsWhereTheLeverArmSays) {
  Truth truth = level(0);
  set_attitude(truth, 0, 0, 90 * degree);
  const auto fix = ideal_gnss(truth, {Eigen::Matrix3d::Identity(), {10, 0, -2}});
  ASSERT_TRUE(fix.position);
  const Vector3d offset = frame::ned_offset(
      {truth.latitude_rad, 0, 0},
      {fix.position->latitude_rad, fix.position->longitude_rad, *fix.ellipsoidal_height_m});
  EXPECT_NEAR((offset - Vector3d(0, 10, -2)).norm(), 0, 1e-6);
}

TEST(IdealGnss, UnderWaterItHasNoFixAndSeesNoSatellites) {
  const Truth deep = level(0.31);
  EXPECT_FALSE(ideal_gnss(deep, {}).position);
  EXPECT_EQ(ideal_gnss(deep, {}).type, measurement::FixType::none);
  EXPECT_TRUE(ideal_sky(deep, true).satellites.empty());
  EXPECT_TRUE(ideal_gnss(level(0.29), {}).position);
  // A mast of 1 m is above the water.
  EXPECT_TRUE(ideal_gnss(level(1.2), {Eigen::Matrix3d::Identity(), {0, 0, -1}}).position);
}

TEST(IdealDepth, PressureIsThatOfTheWaterColumnAboveTheSensor) {
  Truth truth = level(50);
  set_attitude(truth, 0, 30 * degree, 0);
  // 2 m ahead of the origin at a pitch of 30 deg: 1 m higher.
  const auto sample =
      ideal_depth(truth, ocean::Ocean({}, {}), {Eigen::Matrix3d::Identity(), {2, 0, 0}});
  EXPECT_NEAR(*sample.depth_m, 49, 1e-12);
  EXPECT_NEAR(*sample.pressure_pa, 101325 + 1025 * 9.806198 * 49, 0.1);
}

TEST(IdealDepth, InTheStandardOceanPressureIsThatOfTheUnescoReport) {
  Truth truth = level(9712.653);
  truth.latitude_rad = 30 * degree;
  rig_config::OceanConfig config;
  config.water.kind = rig_config::WaterKind::standard;
  const auto sample = ideal_depth(truth, ocean::Ocean(config, {}), {});
  EXPECT_NEAR(*sample.pressure_pa, 101325 + 1e8, 10);
}

TEST(IdealSky, HasTheElevationsAndSignalsOfARealOne) {
  for (int hour = 0; hour < 24; ++hour) {
    Truth truth = level(0);
    truth.at = stamp_from_ns(1'700'000'000'000'000'000 + hour * 3'600'000'000'000);
    const auto sky = ideal_sky(truth, false);
    ASSERT_EQ(sky.satellites.size(), 10);
    for (const auto& satellite : sky.satellites) {
      EXPECT_GT(*satellite.elevation_rad, 0);
      EXPECT_LT(*satellite.elevation_rad, 90 * degree);
      EXPECT_GE(*satellite.azimuth_rad, 0);
      EXPECT_LT(*satellite.azimuth_rad, 360 * degree);
      EXPECT_GT(*satellite.cno_dbhz, 30);
      EXPECT_LT(*satellite.cno_dbhz, 50);
    }
  }
}

}  // namespace
}  // namespace drydock::sensor
