// Anybody on the bus may write such data. The subscriber counts them and goes on.
#include <dds/dds.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "drivers/bus/cdr/cdr_measurements.hpp"
#include "drivers/bus/endpoint.hpp"
#include "drivers/bus/topic.hpp"
#include "tests/drivers/bus/bus_fixture.hpp"
#include "tests/drivers/bus/child_process.hpp"
#include "tests/drivers/bus/hostile_writer.hpp"

namespace drydock::bus::test {
namespace hostile_writer_test {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A writer that sends any message, and a subscriber that takes all measurements.
template <class Message>
class Foreign {
 public:
  explicit Foreign(const std::string& topic)
      : participant_(test_domain()),
        topic_(make_topic<Message>(participant_.handle(), topic)),
        writer_(dds_create_writer(participant_.handle(), topic_.handle(), make_qos(10, 0, "").get(),
                                  nullptr),
                "foreign writer"),
        subscriber_(participant_, all_devices(), {.estimators = {"est"}, .diagnostics = true}) {
    EXPECT_TRUE(eventually([this] { return subscriber_.matched_writers() == 1; }));
  }

  /// The measurements from one message. If there are none, `unusable()` has risen by one.
  std::vector<Measurement> write(Message& message) {
    if (message.header.frame_id == nullptr) message.header.frame_id = frame_.data();
    const auto before = subscriber_.unusable();
    EXPECT_EQ(dds_write(writer_.handle(), &message), DDS_RETCODE_OK);
    std::vector<Measurement> taken;
    EXPECT_TRUE(eventually([&] {
      subscriber_.take_measurements([&](const Measurement& m) { taken.push_back(m); });
      return !taken.empty() || subscriber_.unusable() == before + 1;
    }));
    return taken;
  }

 private:
  Participant participant_;
  Entity topic_, writer_;
  Subscriber subscriber_;
  std::string frame_ = "x";
};

TEST(HostileWriter, AnImuOfNaNsIsNoMeasurementAndTheNextOneIs) {
  Foreign<ImuMessage> foreign("rt/imu/data");
  for (const double bad : {nan, std::numeric_limits<double>::infinity()}) {
    ImuMessage message{};
    message.angular_velocity.y = bad;
    EXPECT_TRUE(foreign.write(message).empty());
  }
  ImuMessage message{};
  message.linear_acceleration.z = 9.81;
  EXPECT_EQ(foreign.write(message).size(), 1U);
}

TEST(HostileWriter, ADepthOfNaNsAndInfinitiesHasNoValue) {
  Foreign<DepthMessage> foreign("rt/depth/depth");
  DepthMessage message{};
  message.depth = nan;
  message.pressure = std::numeric_limits<double>::infinity();
  message.temperature = -std::numeric_limits<double>::infinity();
  message.altitude = nan;
  const auto taken = foreign.write(message);
  ASSERT_EQ(taken.size(), 1U);
  const auto& depth = std::get<measurement::DepthSample>(taken[0]);
  EXPECT_FALSE(depth.depth_m || depth.pressure_pa || depth.temperature_k || depth.altitude_m);
}

TEST(HostileWriter, AFixOfNoKnownTypeIsNoMeasurement) {
  Foreign<GnssFixMessage> foreign("rt/gnss/solution");
  GnssFixMessage message{};
  message.fix_type = 200;
  EXPECT_TRUE(foreign.write(message).empty());
  message.fix_type = 0;
  message.latitude = nan;
  const auto taken = foreign.write(message);
  ASSERT_EQ(taken.size(), 1U);
  EXPECT_FALSE(std::get<measurement::GnssFix>(taken[0]).position);
}

TEST(HostileWriter, AHundredThousandSatellitesAreNotTaken) {
  Foreign<GnssSatellitesMessage> foreign("rt/gnss/satellites");
  std::vector<drydock_msg_dds__Satellite_> all(100'000);
  GnssSatellitesMessage message{};
  message.satellites._buffer = all.data();
  message.satellites._maximum = message.satellites._length = 100'000;
  EXPECT_TRUE(foreign.write(message).empty());
  message.satellites._length = 4;
  EXPECT_EQ(foreign.write(message).size(), 1U);
}

TEST(HostileWriter, AFrameNameOfAMegabyteIsPassedOver) {
  Foreign<ImuMessage> foreign("rt/imu/data");
  std::string name(1u << 20, 'x');
  ImuMessage message{};
  message.header.frame_id = name.data();
  EXPECT_EQ(foreign.write(message).size(), 1U);
}

TEST(HostileBytes, AHeaderAloneIsNoMessage) {
  CdrMeasurements measurements;
  for (const auto kind : {Kind::dvl, Kind::gnss, Kind::imu, Kind::actuator}) {
    EXPECT_FALSE(measurements.read(kind, {}, {}));
    EXPECT_FALSE(measurements.read(kind, std::array<std::uint8_t, 4>{0, 1, 0, 0}, {}));
  }
}

TEST(HostileWriter, BytesThatAreNotTheTypeNeverReachTheSubscriberAndItGoesOn) {
  const Participant participant(test_domain());
  Subscriber subscriber(participant, all_devices());
  // It is another process, because inside one process Cyclone passes messages on without a check of
  // their bytes.
  const ChildProcess other({"--child", "garbage", std::to_string(test_domain())});
  EXPECT_EQ(other.read_line(), "written");
  const auto taken = take(subscriber, 1);
  ASSERT_EQ(taken.size(), 1U) << "the good sample that the other process wrote last";
  const auto& satellites = std::get<measurement::GnssSatellites>(taken[0]);
  EXPECT_EQ(satellites.satellites.size(), 0U);
  EXPECT_EQ(satellites.origin.valid_at, stamp_from_ns(good_sample_ns));
}

}  // namespace hostile_writer_test
}  // namespace drydock::bus::test
