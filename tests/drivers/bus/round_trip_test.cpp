#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include "drivers/bus/convert/convert.hpp"
#include "tests/drivers/bus/bus_fixture.hpp"

namespace drydock::bus::test {
namespace {

using namespace measurement;

/// Connected publisher and subscriber of all devices.
struct Loop {
  explicit Loop(Provenance declared = Provenance::emulated, SubscriberOptions options = {})
      : participant(test_domain()),
        publisher(participant, all_devices(declared), {"leveling"}),
        subscriber(participant, all_devices(Provenance::real), options) {
    EXPECT_TRUE(eventually([this] { return subscriber.matched_writers() >= 8; }));
  }

  template <class Sample>
  Sample through(const Sample& sample) {
    publisher.publish(Measurement{sample});
    const auto taken = take(subscriber, 1);
    if (taken.size() != 1) throw std::runtime_error("not one measurement came");
    return std::get<Sample>(taken[0]);
  }

  Participant participant;
  Publisher publisher;
  Subscriber subscriber;
};

void expect_same_origin(const Origin& got, const Origin& sent) {
  EXPECT_EQ(got.valid_at, sent.valid_at);
  EXPECT_EQ(got.received_at, sent.received_at);
  EXPECT_EQ(got.device_time, sent.device_time);
  EXPECT_EQ(got.provenance, sent.provenance);
  EXPECT_EQ(got.device, sent.device);
}

TEST(Bus, ImuSampleArrivesWithTheSameDoublesButWithoutDeviceTime) {
  Loop loop;
  const ImuSample sent{origin(imu), {0.1, -1.0 / 3, -9.80665}, {1e-5, -7.292115e-5, 0.2}};
  const auto got = loop.through(sent);
  auto expected = sent.origin;
  expected.device_time.reset();
  expect_same_origin(got.origin, expected);
  EXPECT_EQ(got.specific_force, sent.specific_force);
  EXPECT_EQ(got.angular_rate, sent.angular_rate);
}

TEST(Bus, DepthSampleArrivesIdentical) {
  Loop loop;
  const DepthSample sent{origin(depth), 31.7, 420'123.25, 277.4, 68.3};
  const auto got = loop.through(sent);
  expect_same_origin(got.origin, sent.origin);
  EXPECT_EQ(got.depth_m, sent.depth_m);
  EXPECT_EQ(got.pressure_pa, sent.pressure_pa);
  EXPECT_EQ(got.temperature_k, sent.temperature_k);
  EXPECT_EQ(got.altitude_m, sent.altitude_m);
}

TEST(Bus, BottomVelocityArrivesIdentical) {
  Loop loop;
  auto sent = only_origin<BottomVelocity>(dvl);
  sent.velocity = Eigen::Vector3d(1.503, -0.021, 0.1);
  sent.error_velocity_mps = -0.003;
  sent.altitude_m = 12.34;
  sent.range_m = {12.1, std::nullopt, 12.3, 12.4};
  sent.heading_rad = 3.1;
  sent.pitch_rad = -0.02;
  sent.roll_rad = 0.01;
  sent.sound_speed_mps = 1491.3;
  sent.velocity_covariance =
      Eigen::Matrix3d{{4e-6, 1e-7, 2e-7}, {1e-7, 5e-6, 3e-7}, {2e-7, 3e-7, 6e-6}};
  sent.figure_of_merit_mps = 0.0025;
  const auto got = loop.through(sent);
  expect_same_origin(got.origin, sent.origin);
  EXPECT_EQ(got.velocity, sent.velocity);
  EXPECT_EQ(got.error_velocity_mps, sent.error_velocity_mps);
  EXPECT_EQ(got.altitude_m, sent.altitude_m);
  EXPECT_EQ(got.range_m, sent.range_m);
  EXPECT_EQ(got.heading_rad, sent.heading_rad);
  EXPECT_EQ(got.pitch_rad, sent.pitch_rad);
  EXPECT_EQ(got.roll_rad, sent.roll_rad);
  EXPECT_EQ(got.sound_speed_mps, sent.sound_speed_mps);
  EXPECT_EQ(got.velocity_covariance, sent.velocity_covariance);
  EXPECT_EQ(got.figure_of_merit_mps, sent.figure_of_merit_mps);
}

TEST(Bus, WaterSpeedArrivesIdentical) {
  Loop loop;
  const WaterSpeed sent{origin(log), 2.06, -0.05, 123'456.7, 0.02};
  const auto got = loop.through(sent);
  expect_same_origin(got.origin, sent.origin);
  EXPECT_EQ(got.longitudinal_mps, sent.longitudinal_mps);
  EXPECT_EQ(got.transverse_mps, sent.transverse_mps);
  EXPECT_EQ(got.distance_m, sent.distance_m);
  EXPECT_EQ(got.sigma_mps, sent.sigma_mps);
}

TEST(Bus, GnssFixArrivesIdentical) {
  Loop loop;
  auto sent = only_origin<GnssFix>(gnss);
  sent.type = FixType::gnss_and_dr;
  sent.utc = stamp_from_ns(1'699'999'999'000'000'001);
  sent.position = Geodetic{0.64, -2.12};
  sent.ellipsoidal_height_m = -32.25;
  sent.mean_sea_level_height_m = 0.5;
  sent.velocity_ned = Eigen::Vector3d(1.0, -2.0, 0.25);
  sent.horizontal_accuracy_m = 1.1;
  sent.vertical_accuracy_m = 2.3;
  sent.speed_accuracy_mps = 0.07;
  sent.position_dop = 1.6;
  sent.satellites_used = 0;
  sent.ground_speed_mps = 2.236;
  sent.course_rad = 5.1;
  sent.quality = FixQuality::rtk_float;
  const auto got = loop.through(sent);
  expect_same_origin(got.origin, sent.origin);
  EXPECT_EQ(got.type, sent.type);
  EXPECT_EQ(got.utc, sent.utc);
  EXPECT_EQ(got.quality, sent.quality);
  ASSERT_TRUE(got.position);
  EXPECT_EQ(got.position->latitude_rad, sent.position->latitude_rad);
  EXPECT_EQ(got.position->longitude_rad, sent.position->longitude_rad);
  EXPECT_EQ(got.ellipsoidal_height_m, sent.ellipsoidal_height_m);
  EXPECT_EQ(got.mean_sea_level_height_m, sent.mean_sea_level_height_m);
  EXPECT_EQ(got.velocity_ned, sent.velocity_ned);
  EXPECT_EQ(got.horizontal_accuracy_m, sent.horizontal_accuracy_m);
  EXPECT_EQ(got.vertical_accuracy_m, sent.vertical_accuracy_m);
  EXPECT_EQ(got.speed_accuracy_mps, sent.speed_accuracy_mps);
  EXPECT_EQ(got.position_dop, sent.position_dop);
  EXPECT_EQ(got.satellites_used, sent.satellites_used);
  EXPECT_EQ(got.ground_speed_mps, sent.ground_speed_mps);
  EXPECT_EQ(got.course_rad, sent.course_rad);
}

TEST(Bus, SatellitesArriveIdenticalUpToTheFullNinetySix) {
  Loop loop;
  for (const std::size_t count : {0u, 1u, 96u, 3u}) {
    auto sent = only_origin<GnssSatellites>(gnss);
    for (std::size_t i = 0; i < count; ++i) {
      Satellite satellite;
      satellite.constellation = static_cast<Constellation>(i % 8);
      satellite.number = static_cast<std::uint8_t>(i);
      satellite.used = i % 3 == 0;
      if (i % 2 == 0) satellite.cno_dbhz = 30.5 + static_cast<double>(i);
      if (i % 5 == 0) satellite.elevation_rad = 0.7;
      if (i % 7 == 0) satellite.azimuth_rad = 5.5;
      sent.satellites.push_back(satellite);
    }
    const auto got = loop.through(sent);
    expect_same_origin(got.origin, sent.origin);
    ASSERT_EQ(got.satellites.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(got.satellites[i].constellation, sent.satellites[i].constellation);
      EXPECT_EQ(got.satellites[i].number, sent.satellites[i].number);
      EXPECT_EQ(got.satellites[i].used, sent.satellites[i].used);
      EXPECT_EQ(got.satellites[i].cno_dbhz, sent.satellites[i].cno_dbhz);
      EXPECT_EQ(got.satellites[i].elevation_rad, sent.satellites[i].elevation_rad);
      EXPECT_EQ(got.satellites[i].azimuth_rad, sent.satellites[i].azimuth_rad);
    }
  }
}

TEST(Bus, ActuatorStateArrivesIdentical) {
  Loop loop;
  const ActuatorState sent{origin(actuator), -0.2, 0.1, std::nullopt, 12.5};
  const auto got = loop.through(sent);
  expect_same_origin(got.origin, sent.origin);
  EXPECT_EQ(got.rudder_rad, sent.rudder_rad);
  EXPECT_EQ(got.stern_plane_rad, sent.stern_plane_rad);
  EXPECT_EQ(got.bow_plane_rad, sent.bow_plane_rad);
  EXPECT_EQ(got.propeller_radps, sent.propeller_radps);
}

TEST(Bus, AttitudeSampleArrivesIdentical) {
  Loop loop;
  const AttitudeSample sent{
      origin(compass), 6.2, HeadingReference::magnetic_north, -0.01, 0.12, 0.0268, -0.1, 0.02, 0.3};
  const auto got = loop.through(sent);
  expect_same_origin(got.origin, sent.origin);
  EXPECT_EQ(got.heading_rad, sent.heading_rad);
  EXPECT_EQ(got.reference, sent.reference);
  EXPECT_EQ(got.deviation_rad, sent.deviation_rad);
  EXPECT_EQ(got.variation_rad, sent.variation_rad);
  EXPECT_EQ(got.true_heading_rad, sent.true_heading_rad);
  EXPECT_EQ(got.roll_rad, sent.roll_rad);
  EXPECT_EQ(got.pitch_rad, sent.pitch_rad);
  EXPECT_EQ(got.rate_of_turn_radps, sent.rate_of_turn_radps);
}

TEST(Bus, WhatADeviceDidNotGiveStaysEmpty) {
  Loop loop;
  const auto depth_sample = loop.through(only_origin<DepthSample>(depth));
  EXPECT_FALSE(depth_sample.depth_m || depth_sample.pressure_pa || depth_sample.temperature_k ||
               depth_sample.altitude_m);
  const auto velocity = loop.through(only_origin<BottomVelocity>(dvl));
  EXPECT_FALSE(velocity.velocity || velocity.error_velocity_mps || velocity.altitude_m ||
               velocity.heading_rad || velocity.pitch_rad || velocity.roll_rad ||
               velocity.sound_speed_mps || velocity.velocity_covariance ||
               velocity.figure_of_merit_mps);
  for (const auto& range : velocity.range_m) EXPECT_FALSE(range);
  const auto speed = loop.through(only_origin<WaterSpeed>(log));
  EXPECT_FALSE(speed.longitudinal_mps || speed.transverse_mps || speed.distance_m ||
               speed.sigma_mps);
  const auto fix = loop.through(only_origin<GnssFix>(gnss));
  EXPECT_EQ(fix.type, FixType::none);
  EXPECT_FALSE(fix.utc || fix.position || fix.ellipsoidal_height_m || fix.mean_sea_level_height_m ||
               fix.velocity_ned || fix.horizontal_accuracy_m || fix.vertical_accuracy_m ||
               fix.speed_accuracy_mps || fix.position_dop || fix.satellites_used ||
               fix.ground_speed_mps || fix.course_rad || fix.quality);
  const auto actuators = loop.through(only_origin<ActuatorState>(actuator));
  EXPECT_FALSE(actuators.rudder_rad || actuators.stern_plane_rad || actuators.bow_plane_rad ||
               actuators.propeller_radps);
  const auto attitude = loop.through(only_origin<AttitudeSample>(compass));
  EXPECT_FALSE(attitude.heading_rad || attitude.deviation_rad || attitude.variation_rad ||
               attitude.true_heading_rad || attitude.roll_rad || attitude.pitch_rad ||
               attitude.rate_of_turn_radps);
}

TEST(Bus, ProvenanceIsThatOfTheWriterNotOfTheSubscribersConfiguration) {
  for (const auto declared : {Provenance::real, Provenance::emulated, Provenance::replayed}) {
    Loop loop(declared);
    auto sent = only_origin<WaterSpeed>(log);
    sent.origin.provenance = declared;
    EXPECT_EQ(loop.through(sent).origin.provenance, declared);
  }
}

TEST(Bus, MeasurementOfTheWrongDeviceKindOrProvenanceIsCountedAndNotPublished) {
  Loop loop;
  loop.publisher.publish(Measurement{only_origin<WaterSpeed>(imu)});
  auto real = only_origin<ImuSample>(imu);
  real.origin.provenance = Provenance::real;
  loop.publisher.publish(Measurement{real});
  auto nowhere = only_origin<ImuSample>(imu);
  nowhere.origin.device = 99;
  loop.publisher.publish(Measurement{nowhere});
  EXPECT_EQ(loop.publisher.misrouted(), 3u);
  for (const auto& topic : loop.publisher.counters()) EXPECT_EQ(topic.written, 0u) << topic.topic;
}

struct Monitor final : Receiver {
  using Receiver::receive;
  void receive(const Measurement&) override {}
  void receive(const Attitude& attitude, std::size_t) override { attitudes.push_back(attitude); }
  void receive(const DeviceStatus& status) override { statuses.push_back(status); }
  std::vector<Attitude> attitudes;
  std::vector<DeviceStatus> statuses;
};

TEST(Bus, AttitudeComesBackInNedWithItsCovarianceAndWithoutYawWhereNoneWasGiven) {
  Loop loop(Provenance::emulated, {.estimators = {"leveling"}, .diagnostics = false});
  Attitude sent{origin(imu).valid_at, 0.3, -0.2, {}, {}};
  sent.covariance << 1e-4, 2e-5, 2e-5, 3e-4;
  loop.publisher.publish(sent, 0);
  sent.yaw_rad = -2.5;
  loop.publisher.publish(sent, 0);
  Monitor monitor;
  ASSERT_TRUE(
      eventually([&] { return loop.subscriber.take(monitor), monitor.attitudes.size() == 2; }));
  for (const auto& got : monitor.attitudes) {
    EXPECT_EQ(got.valid_at, sent.valid_at);
    EXPECT_NEAR(got.roll_rad, sent.roll_rad, 1e-15);
    EXPECT_NEAR(got.pitch_rad, sent.pitch_rad, 1e-15);
    EXPECT_EQ(got.covariance, sent.covariance);
  }
  EXPECT_FALSE(monitor.attitudes[0].yaw_rad);
  EXPECT_NEAR(monitor.attitudes[1].yaw_rad.value(), -2.5, 1e-15);
}

TEST(Bus, HealthComesBackAsItWasSent) {
  Loop loop(Provenance::emulated, {.estimators = {}, .diagnostics = true});
  const std::vector<DeviceStatus> sent{
      {Level::ok, "imu", "streaming", "socketcan:can0", {{"rate", "100 Hz"}, {"age", "0.01 s"}}},
      {Level::stale, "dvl", "no bytes for 3 s", "serial:/dev/ttyUSB0", {}}};
  loop.publisher.publish(std::span(sent).first(1), stamp_from_ns(5));
  loop.publisher.publish(sent, stamp_from_ns(6));
  Monitor monitor;
  ASSERT_TRUE(
      eventually([&] { return loop.subscriber.take(monitor), monitor.statuses.size() == 3; }));
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(monitor.statuses[i + 1].level, sent[i].level);
    EXPECT_EQ(monitor.statuses[i + 1].name, sent[i].name);
    EXPECT_EQ(monitor.statuses[i + 1].message, sent[i].message);
    EXPECT_EQ(monitor.statuses[i + 1].hardware_id, sent[i].hardware_id);
    EXPECT_EQ(monitor.statuses[i + 1].values, sent[i].values);
  }
}

RC_GTEST_PROP(BusConversion, FramesAreTurnedByExactSignFlips, (double x, double y, double z)) {
  const Eigen::Vector3d v(x, y, z);
  RC_ASSERT(half_turn_about_x(half_turn_about_x(v)) == v);
  RC_ASSERT(swap_ned_enu(swap_ned_enu(v)) == v);
}

RC_GTEST_PROP(BusConversion, EveryStampOfTheCommonEraSurvives, (std::int32_t s, std::uint32_t ns)) {
  const auto stamp = stamp_from_ns(s * std::int64_t{1'000'000'000} + ns % 1'000'000'000);
  RC_ASSERT(to_stamp(to_time(stamp)) == stamp);
}

}  // namespace
}  // namespace drydock::bus::test
