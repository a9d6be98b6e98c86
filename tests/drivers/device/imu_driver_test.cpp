#include <bit>

#include "tests/drivers/device/support.hpp"

namespace drydock::device::test {
namespace imu_driver_test {

using measurement::ImuSample;

constexpr std::uint32_t accs_id = 0x08F02D80, ari_id = 0x0CF02A80, ssi2_id = 0x0CF02980;

// Frames of a real MTLT305. Its maker's DBC gives the expected values.
const auto accs = can_frame(accs_id, true, {0x31, 0x79, 0x55, 0x7D, 0x0A, 0x7D, 0x80, 0x06});
const auto ari = can_frame(ari_id, true, {0xC9, 0x81, 0xEB, 0x7C, 0x79, 0x79, 0x00, 0x06});
const auto ssi2 = can_frame(ssi2_id, true, {0xC7, 0xAA, 0x7E, 0x5C, 0x82, 0x6B, 0x44, 0x06});

struct Bus {
  explicit Bus(const DriverOptions& o) : driver(frame_driver(o)) {}
  void says(const wire::CanFrame& frame, double at) { driver->receive(frame, at_s(at), ear); }
  std::vector<ImuSample> samples() const { return ear.all<ImuSample>(); }

  Ear ear;
  std::unique_ptr<FrameDriver> driver;
};

TEST(AceinnaImuDriver, PairsAccelerationAndRateIntoOneSample) {
  Bus bus(options(Kind::imu, "aceinna"));
  bus.says(ssi2, 0.9996);
  bus.says(accs, 0.9999);
  EXPECT_TRUE(bus.samples().empty());
  bus.says(ari, 1);
  ASSERT_EQ(bus.samples().size(), 1U);
  const ImuSample s = bus.samples()[0];
  EXPECT_NEAR(s.specific_force.x(), -9.75, 1e-9);
  EXPECT_NEAR(s.specific_force.y(), 0.85, 1e-9);
  EXPECT_NEAR(s.specific_force.z(), 0.10, 1e-9);
  EXPECT_NEAR(s.angular_rate.x(), 9.5703125 * degree, 1e-9);
  EXPECT_NEAR(s.angular_rate.y(), -0.1640625 * degree, 1e-9);
  EXPECT_NEAR(s.angular_rate.z(), -7.0546875 * degree, 1e-9);
  EXPECT_EQ(s.origin.received_at, at_s(1));
  // ARI states 3 ms. Its frame takes 128 bits at 250 kbit/s and 6 stuff bits (timing_test).
  EXPECT_EQ(s.origin.valid_at, at_s(1) - std::chrono::microseconds{3000 + 536});
}

TEST(AceinnaImuDriver, HalvesOfTwoSamplesAreNotPaired) {
  Bus bus(options(Kind::imu, "aceinna"));
  bus.says(accs, 1);
  bus.says(ari, 1.0099);  // its own ACCS was lost
  EXPECT_TRUE(bus.samples().empty());
  bus.says(accs, 1.01);
  EXPECT_EQ(bus.samples().size(), 1U);
}

TEST(AceinnaImuDriver, ErrorAndNotAvailableNeverBecomeNumbers) {
  Bus bus(options(Kind::imu, "aceinna"));
  auto broken = accs;
  broken.data[2] = 0xFF, broken.data[3] = 0xFF;  // Y not available
  bus.says(broken, 1);
  bus.says(ari, 1.0001);
  auto faulty = ari;
  faulty.data[0] = 0x00, faulty.data[1] = 0xFE;  // X error
  bus.says(accs, 1.01);
  bus.says(faulty, 1.0101);
  EXPECT_TRUE(bus.samples().empty());
}

TEST(AceinnaImuDriver, StaysWithTheFirstSensorHeard) {
  Bus bus(options(Kind::imu, "aceinna"));
  auto other_accs = accs, other_ari = ari;
  other_accs.id = accs_id + 1;
  other_ari.id = ari_id + 1;
  bus.says(accs, 1);
  bus.says(other_accs, 1.0001);
  bus.says(other_ari, 1.0002);
  EXPECT_TRUE(bus.samples().empty());
  bus.says(ari, 1.0003);
  EXPECT_EQ(bus.samples().size(), 1U);
}

TEST(AceinnaImuDriver, ConfiguredAddressIsTheOnlyOneHeard) {
  DriverOptions o = options(Kind::imu, "aceinna");
  o.address = 0x81;
  Bus bus(o);
  bus.says(accs, 1);
  bus.says(ari, 1.0001);
  EXPECT_TRUE(bus.samples().empty());
}

TEST(AceinnaImuDriver, MountingTurnsBothVectors) {
  DriverOptions o = options(Kind::imu, "aceinna");
  o.mounting = {180 * degree, 0, 0};  // upside down
  Bus bus(o);
  bus.says(accs, 1);
  bus.says(ari, 1.0001);
  const ImuSample s = bus.samples().at(0);
  EXPECT_NEAR(s.specific_force.x(), -9.75, 1e-9);
  EXPECT_NEAR(s.specific_force.y(), -0.85, 1e-9);
  EXPECT_NEAR(s.angular_rate.z(), 7.0546875 * degree, 1e-9);
}

wire::CanFrame tpdo(std::uint32_t id, float first, float second) {
  wire::CanFrame frame;
  frame.id = id;
  frame.size = 8;
  const auto a = std::bit_cast<std::uint32_t>(first), b = std::bit_cast<std::uint32_t>(second);
  for (std::size_t i = 0; i < 4; ++i) {
    frame.data[i] = static_cast<std::uint8_t>(a >> (8 * i));
    frame.data[4 + i] = static_cast<std::uint8_t>(b >> (8 * i));
  }
  return frame;
}

void one_set(Bus& bus, double at, double apart = 0.0005, unsigned node = 1) {
  bus.says(tpdo(0x180 + node, 0.125F, 0.25F), at);
  bus.says(tpdo(0x280 + node, 0.5F, 1.0F), at + apart);
  bus.says(tpdo(0x380 + node, 2.0F, -9.75F), at + 2 * apart);
}

TEST(Cia404ImuDriver, ThreeFramesAreOneSampleTrueBeforeTheFirst) {
  Bus bus(options(Kind::imu, "cia404-imu"));
  one_set(bus, 1);
  ASSERT_EQ(bus.samples().size(), 1U);
  const ImuSample s = bus.samples()[0];
  EXPECT_EQ(s.angular_rate, Eigen::Vector3d(0.125, 0.25, 0.5));
  EXPECT_EQ(s.specific_force, Eigen::Vector3d(1, 2, -9.75));
  EXPECT_EQ(s.origin.valid_at,
            at_s(1) - std::chrono::microseconds{480});  // 108 bits and 12 stuff bits
  EXPECT_EQ(s.origin.received_at, at_s(1.001));
}

TEST(Cia404ImuDriver, SetOfTwoSamplesIsRefused) {
  Bus bus(options(Kind::imu, "cia404-imu"));
  one_set(bus, 1, 0.01);
  EXPECT_TRUE(bus.samples().empty());
  EXPECT_EQ(bus.ear.reports.size(), 1U);
}

TEST(Cia404ImuDriver, AFloatWithABitTurnedOverInItsExponentIsNoSample) {
  Bus bus(options(Kind::imu, "cia404-imu"));
  const auto turned = [](float x) {
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) ^ 1U << 30);
  };
  for (const auto& [rate, force] :
       {std::pair(turned(0.5F), 2.0F), std::pair(0.5F, turned(-0.01F))}) {
    bus.says(tpdo(0x181, 0.125F, 0.25F), 1);
    bus.says(tpdo(0x281, rate, 1.0F), 1.0005);
    bus.says(tpdo(0x381, force, -9.75F), 1.001);
  }
  EXPECT_TRUE(bus.samples().empty()) << bus.samples().at(0).specific_force;
  ASSERT_EQ(bus.ear.refusals.size(), 2U);
  EXPECT_EQ(bus.ear.refusals[0],
            "a sample beyond 100 rad/s or 2000 m/s2 was dropped: damaged on its way");
  one_set(bus, 2);
  EXPECT_EQ(bus.samples().size(), 1U);
}

TEST(Cia404ImuDriver, StartsItsNodeWhenTheBusOpensAndAfterABootUp) {
  DriverOptions o = options(Kind::imu, "cia404-imu");
  o.address = 5;
  Bus bus(o);
  bus.driver->restart(at_s(0), bus.ear);
  bus.says(can_frame(0x705, false, {0x00}), 1);  // our node boots
  bus.says(can_frame(0x706, false, {0x00}), 1);  // another node
  bus.says(can_frame(0x705, false, {0x05}), 2);  // heartbeat, operational
  const auto start_5 = can_frame(0x000, false, {0x01, 0x05});
  EXPECT_EQ(bus.ear.sent_frames, (std::vector{start_5, start_5}));
}

TEST(Cia404ImuDriver, WithoutAnAddressItStartsNoNode) {
  Bus bus(options(Kind::imu, "cia404-imu"));
  bus.driver->restart(at_s(0), bus.ear);
  EXPECT_TRUE(bus.ear.sent_frames.empty());
}

TEST(Cia404ImuDriver, EmergencyIsReportedInWords) {
  Bus bus(options(Kind::imu, "cia404-imu"));
  bus.says(can_frame(0x081, false, {0x30, 0x81, 0x11, 0, 0, 0, 0, 0}), 1);
  ASSERT_EQ(bus.ear.reports.size(), 1U);
  EXPECT_EQ(bus.ear.reports[0], "node 1: emergency 0x8130, life guard or heartbeat error");
}

TEST(Cia404ImuDriver, NotANumberGivesNoSample) {
  Bus bus(options(Kind::imu, "cia404-imu"));
  bus.says(tpdo(0x181, std::bit_cast<float>(0x7FC00000U), 0.25F), 1);
  bus.says(tpdo(0x281, 0.5F, 1.0F), 1.0005);
  bus.says(tpdo(0x381, 2.0F, -9.75F), 1.001);
  EXPECT_TRUE(bus.samples().empty());
}

}  // namespace imu_driver_test
}  // namespace drydock::device::test
