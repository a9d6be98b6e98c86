#include <gtest/gtest.h>

#include <utility>

#include "drivers/bus/convert/convert.hpp"
#include "tests/drivers/bus/bus_fixture.hpp"

namespace drydock::bus::test {
namespace {

using namespace measurement;

/// A subscriber that takes only ROS 2's messages, as for a device that a ROS 2 node drives.
struct StandardLoop {
  StandardLoop()
      : participant(test_domain()),
        publisher(participant, all_devices()),
        subscriber(participant, all_devices(Provenance::real, Form::standard)) {
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

TEST(BusStandardForm, DvlKeepsVelocityAltitudeAndSoundSpeedOnly) {
  StandardLoop loop;
  auto sent = only_origin<BottomVelocity>(dvl);
  sent.velocity = Eigen::Vector3d(1.503, -0.021, 0.1);
  sent.altitude_m = 12.34;
  sent.range_m = {12.1, 12.2, 12.3, 12.4};
  sent.error_velocity_mps = 0.01;
  sent.heading_rad = 1;
  sent.sound_speed_mps = 1491.3;
  const auto got = loop.through(sent);
  EXPECT_EQ(got.origin.valid_at, sent.origin.valid_at);
  EXPECT_EQ(got.origin.received_at, sent.origin.received_at);
  EXPECT_EQ(got.origin.provenance, Provenance::emulated);
  EXPECT_EQ(got.velocity, sent.velocity);
  EXPECT_EQ(got.altitude_m, sent.altitude_m);
  EXPECT_NEAR(got.sound_speed_mps.value(), 1491.3, 1e-4);  // float32 on the wire
  EXPECT_FALSE(got.error_velocity_mps || got.heading_rad || got.range_m[0]);
}

TEST(BusStandardForm, DvlWithoutBottomLockHasNoVelocity) {
  StandardLoop loop;
  const auto got = loop.through(only_origin<BottomVelocity>(dvl));
  EXPECT_FALSE(got.velocity || got.altitude_m || got.sound_speed_mps);
}

TEST(BusStandardForm, WaterSpeedKeepsWhichComponentsWereMeasured) {
  StandardLoop loop;
  const auto both = loop.through(WaterSpeed{origin(log), 2.06, -0.05, 100.0, {}});
  EXPECT_EQ(both.longitudinal_mps, 2.06);
  EXPECT_EQ(both.transverse_mps, -0.05);
  EXPECT_FALSE(both.distance_m);
  const auto ahead = loop.through(WaterSpeed{origin(log), 0.0, {}, {}, {}});
  EXPECT_EQ(ahead.longitudinal_mps, 0.0);
  EXPECT_FALSE(ahead.transverse_mps);
}

TEST(BusStandardForm, NothingMeasuredIsNoTwistAtAll) {
  StandardLoop loop;
  loop.publisher.publish(Measurement{only_origin<WaterSpeed>(log)});
  EXPECT_EQ(loop.through(WaterSpeed{origin(log), 1.5, {}, {}, {}}).longitudinal_mps, 1.5);
}

TEST(BusStandardForm, NavSatFixKeepsPositionAndAccuracyAndNoFixIsEmpty) {
  StandardLoop loop;
  auto sent = only_origin<GnssFix>(gnss);
  sent.type = FixType::three_d;
  sent.position = Geodetic{0.64, -2.12};
  sent.ellipsoidal_height_m = -32.25;
  sent.horizontal_accuracy_m = 1.1;
  sent.vertical_accuracy_m = 2.3;
  const auto got = loop.through(sent);
  EXPECT_EQ(got.type, FixType::three_d);
  EXPECT_NEAR(got.position.value().latitude_rad, 0.64, 1e-15);
  EXPECT_NEAR(got.position.value().longitude_rad, -2.12, 1e-15);
  EXPECT_EQ(got.ellipsoidal_height_m, -32.25);
  EXPECT_NEAR(got.horizontal_accuracy_m.value(), 1.1, 1e-15);
  EXPECT_EQ(got.vertical_accuracy_m, 2.3);
  const auto none = loop.through(only_origin<GnssFix>(gnss));
  EXPECT_FALSE(none.position || none.ellipsoidal_height_m || none.horizontal_accuracy_m);
}

// GST with 0.3 m and 0.4 m is 0.5 m together, 0.125 m2 each.
TEST(BusConversion, ANavSatFixHasHalfOfTheRadialVarianceInEachAxis) {
  auto sent = only_origin<GnssFix>(gnss);
  sent.horizontal_accuracy_m = 0.5;
  sent.vertical_accuracy_m = 2;
  NavSatFixMessage message{};
  ASSERT_TRUE(fill(message, sent));
  EXPECT_NEAR(message.position_covariance[0], 0.125, 1e-15);
  EXPECT_NEAR(message.position_covariance[4], 0.125, 1e-15);
  EXPECT_EQ(message.position_covariance[8], 4);
}

TEST(BusStandardForm, DepthSensorIsItsPressure) {
  StandardLoop loop;
  const auto got = loop.through(DepthSample{origin(depth), 31.7, 420'123.25, 277.4, {}});
  EXPECT_EQ(got.pressure_pa, 420'123.25);
  EXPECT_FALSE(got.depth_m || got.temperature_k || got.altitude_m);
}

TEST(BusConversion, DvlThatReportsZerosWithoutGoodBeamsHasNoVelocity) {
  DvlMessage message{};
  message.velocity_mode = 1;
  BottomVelocity sample;
  ASSERT_TRUE(read(sample, message));
  EXPECT_FALSE(sample.velocity || sample.altitude_m || sample.sound_speed_mps);
}

BottomVelocity moving() {
  BottomVelocity sample;
  sample.velocity = Eigen::Vector3d(1.5, 0.1, -0.2);
  return sample;
}

/// marine_acoustic_msgs/Dvl: a first element of -1 says that the covariance is not known.
TEST(BusConversion, ADvlMessageHasTheCovarianceThatTheDvlTellsOrMinusOne) {
  DvlMessage message{};
  auto sample = moving();
  ASSERT_TRUE(fill(message, sample));
  EXPECT_EQ(message.velocity_covar[0], -1);
  sample.figure_of_merit_mps = 0.5;
  ASSERT_TRUE(fill(message, sample));
  EXPECT_EQ(message.velocity_covar[0], 0.25);
  EXPECT_EQ(message.velocity_covar[1], 0);
  EXPECT_EQ(message.velocity_covar[8], 0.25);
  sample.velocity_covariance = Eigen::Matrix3d{{4, 0.5, 0.25}, {0.5, 9, 0.125}, {0.25, 0.125, 16}};
  ASSERT_TRUE(fill(message, sample));
  EXPECT_EQ(message.velocity_covar[0], 4);
  EXPECT_EQ(message.velocity_covar[1], 0.5);
  EXPECT_EQ(message.velocity_covar[5], 0.125);
  sample.velocity.reset();
  ASSERT_TRUE(fill(message, sample));
  EXPECT_EQ(message.velocity_covar[0], -1);
}

TEST(BusConversion, NoTwistSaysThatAVelocityIsExact) {
  TwistMessage message{};
  ASSERT_TRUE(fill(message, moving()));
  EXPECT_EQ(message.twist.covariance[0], 1e6);
  WaterSpeed speed;
  speed.longitudinal_mps = 2;
  ASSERT_TRUE(fill(message, speed));
  EXPECT_EQ(message.twist.covariance[0], 1e6);
  speed.sigma_mps = 0.5;
  ASSERT_TRUE(fill(message, speed));
  EXPECT_EQ(message.twist.covariance[0], 0.25);
  EXPECT_EQ(message.twist.covariance[7], -1) << "not measured";
  GnssFix fix;
  fix.velocity_ned = Eigen::Vector3d(1, 2, 3);
  ASSERT_TRUE(fill(message, fix));
  EXPECT_EQ(message.twist.covariance[14], 1e6);
  fix.speed_accuracy_mps = 0;
  ASSERT_TRUE(fill(message, fix));
  EXPECT_EQ(message.twist.covariance[14], 1e6);
}

/// sensor_msgs/NavSatStatus: -1 no fix, 0 unaugmented, 1 satellite-based, 2 ground-based.
TEST(BusConversion, NavSatStatusTellsWhatAugmentsTheFix) {
  using enum FixQuality;
  NavSatFixMessage message{};
  GnssFix fix;
  ASSERT_TRUE(fill(message, fix));
  EXPECT_EQ(message.status.status, -1);
  fix.position = Geodetic{0.64, -2.12};
  const std::pair<std::optional<FixQuality>, int> expected[] = {
      {std::nullopt, 0}, {autonomous, 0}, {differential, 1},
      {rtk_float, 2},    {rtk_fixed, 2},  {dead_reckoning, 0}};
  for (const auto& [quality, status] : expected) {
    fix.quality = quality;
    ASSERT_TRUE(fill(message, fix));
    EXPECT_EQ(message.status.status, status);
    EXPECT_EQ(message.position_covariance_type, 0) << "not known: no accuracy was told";
  }
}

TEST(BusConversion, DvlInWaterTrackModeIsNotABottomVelocity) {
  DvlMessage message{};
  message.velocity_mode = 2;
  message.num_good_beams = 4;
  BottomVelocity sample;
  EXPECT_FALSE(read(sample, message));
}

TEST(BusConversion, OrientationWithoutRatesIsNotAnImuSample) {
  ImuMessage message{};
  fill(message, Attitude{});
  ImuSample sample;
  EXPECT_FALSE(read(sample, message));
  fill(message = {}, ImuSample{});
  Attitude attitude;
  EXPECT_FALSE(read(attitude, message));
}

TEST(BusConversion, UnknownEnumeratorsAndTooManySatellitesAreRefused) {
  GnssFixMessage fix{};
  fix.fix_type = 6;
  GnssFix fix_sample;
  EXPECT_FALSE(read(fix_sample, fix));
  fix.fix_type = 3;
  fix.quality = 6;
  EXPECT_FALSE(read(fix_sample, fix));
  drydock_msg_dds__Satellite_ satellites[97]{};
  satellites[0].constellation = 8;
  GnssSatellitesMessage message{};
  message.satellites._buffer = satellites;
  message.satellites._length = 1;
  GnssSatellites sample;
  EXPECT_FALSE(read(sample, message));
  message.satellites._length = 97;
  EXPECT_FALSE(read(sample, message));
}

}  // namespace
}  // namespace drydock::bus::test
