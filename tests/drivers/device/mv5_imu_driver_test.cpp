#include "tests/drivers/device/support.hpp"

namespace drydock::device::test {
namespace mv5_imu_driver_test {

using measurement::ImuSample;

// By SAE's table: lateral 0.25, longitudinal -1, vertical 9.81 m/s2; pitch 1, roll -0.5, yaw 2
// deg/s with a latency of 4 ms.
const auto force = can_frame(0x08F02DE2, true, {0x19, 0x7D, 0x9C, 0x7C, 0xD5, 0x80, 0x00, 0xFF});
const auto rate = can_frame(0x0CF02AE2, true, {0x80, 0x7D, 0xC0, 0x7C, 0x00, 0x7E, 0x00, 0x08});

struct Mv5Bus {
  explicit Mv5Bus(const DriverOptions& o) : driver(frame_driver(o)) {}
  void says(const wire::CanFrame& frame, double at) { driver->receive(frame, at_s(at), ear); }
  std::vector<ImuSample> samples() const { return ear.all<ImuSample>(); }

  Ear ear;
  std::unique_ptr<FrameDriver> driver;
};

TEST(Mv5ImuDriver, LongitudinalIsXAndLateralIsY) {
  Mv5Bus bus(options(Kind::imu, "microstrain-mv5"));
  bus.says(force, 0.9995);
  bus.says(rate, 1);
  ASSERT_EQ(bus.samples().size(), 1U);
  const ImuSample s = bus.samples()[0];
  EXPECT_NEAR(s.specific_force.x(), -1, 1e-9);
  EXPECT_NEAR(s.specific_force.y(), 0.25, 1e-9);
  EXPECT_NEAR(s.specific_force.z(), 9.81, 1e-9);
  EXPECT_NEAR(s.angular_rate.x(), -0.5 * degree, 1e-9);  // roll
  EXPECT_NEAR(s.angular_rate.y(), 1 * degree, 1e-9);     // pitch
  EXPECT_NEAR(s.angular_rate.z(), 2 * degree, 1e-9);     // yaw
  // Before the frame of about 0.5 ms: 4 ms.
  const auto age = at_s(1) - s.origin.valid_at;
  EXPECT_GT(age, std::chrono::microseconds{4400});
  EXPECT_LT(age, std::chrono::microseconds{4600});
}

TEST(Mv5ImuDriver, TheMountingTurnsZUpToZDown) {
  auto o = options(Kind::imu, "microstrain-mv5");
  o.mounting = Mounting(180 * degree, 0, 0);
  Mv5Bus bus(o);
  bus.says(force, 0.9995);
  bus.says(rate, 1);
  ASSERT_EQ(bus.samples().size(), 1U);
  EXPECT_NEAR(bus.samples()[0].specific_force.z(), -9.81, 1e-9);
  EXPECT_NEAR(bus.samples()[0].specific_force.y(), -0.25, 1e-9);
}

TEST(Mv5ImuDriver, AComponentThatIsNotThereGivesNoSample) {
  Mv5Bus bus(options(Kind::imu, "microstrain-mv5"));
  auto broken = force;
  broken.data[2] = 0xFF, broken.data[3] = 0xFF;
  bus.says(broken, 0.9995);
  bus.says(rate, 1);
  auto faulty = rate;
  faulty.data[6] = 0x02;  // merit of the pitch rate: error
  bus.says(force, 1.0095);
  bus.says(faulty, 1.01);
  EXPECT_TRUE(bus.samples().empty());
}

TEST(Mv5ImuDriver, TwoUnitsOnOneBusAreNotMixed) {
  Mv5Bus bus(options(Kind::imu, "microstrain-mv5"));
  auto other = rate;
  other.id = 0x0CF02AE3;
  bus.says(force, 0.9995);
  bus.says(other, 0.9998);
  EXPECT_TRUE(bus.samples().empty());
  bus.says(rate, 1);
  EXPECT_EQ(bus.samples().size(), 1U);
}

}  // namespace mv5_imu_driver_test
}  // namespace drydock::device::test
