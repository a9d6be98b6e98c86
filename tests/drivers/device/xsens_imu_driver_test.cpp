#include <gtest/gtest.h>

#include "drivers/wire/can/can_bits.hpp"
#include "tests/drivers/device/support.hpp"

/// The frames are written by hand from the tables of MT1604P.
namespace drydock::device::test {
namespace xsens_imu_driver_test {

using measurement::ImuSample;
using namespace std::chrono_literals;

constexpr unsigned sample_time = 0x005, group_counter = 0x006, status_word = 0x011;

const auto rate = can_frame(0x032, false, {0x00, 0x33, 0xFF, 0x80, 0x05, 0x00});
const auto force = can_frame(0x034, false, {0x01, 0x80, 0xFD, 0xC0, 0x09, 0xCF});

wire::CanFrame ticks(std::uint32_t t) {
  return can_frame(sample_time, false, {t >> 24, t >> 16 & 0xFF, t >> 8 & 0xFF, t & 0xFF});
}
wire::CanFrame counter(unsigned c) {
  return can_frame(group_counter, false, {c >> 8 & 0xFF, c & 0xFF});
}
wire::CanFrame status(std::uint32_t s) {
  auto frame = ticks(s);
  frame.id = status_word;
  return frame;
}

struct Bus {
  explicit Bus(const DriverOptions& o = options(Kind::imu, "xsens")) : driver(frame_driver(o)) {}
  void says(const wire::CanFrame& frame, Stamp at) { driver->receive(frame, at, ear); }
  /// Sends frames 0.4 ms apart. The first frame starts 304 us before `at`, whatever its stuff bits.
  void says(std::initializer_list<wire::CanFrame> frames, double at) {
    constexpr unsigned intermission_bits = 3;
    Stamp end = at_s(at) - 304us + 4us * (wire::wire_bits(*frames.begin()) - intermission_bits);
    for (const auto& frame : frames) {
      says(frame, end);
      end = at_s(at += 0.0004);
    }
  }
  std::vector<ImuSample> samples() const { return ear.all<ImuSample>(); }

  Ear ear;
  std::unique_ptr<FrameDriver> driver;
};

TEST(XsensImuDriver, RateAndAccelerationOfAGroupAreOneSample) {
  Bus bus;
  bus.says({ticks(1000), counter(7), rate, force}, 1);
  ASSERT_EQ(bus.samples().size(), 1U);
  const ImuSample s = bus.samples()[0];
  EXPECT_EQ(s.angular_rate, Eigen::Vector3d(0.099609375, -0.25, 2.5));
  EXPECT_EQ(s.specific_force, Eigen::Vector3d(1.5, -2.25, 9.80859375));
  EXPECT_EQ(s.origin.received_at, at_s(1.0012));
  EXPECT_EQ(s.origin.valid_at, at_s(1) - 304us);
  EXPECT_EQ(s.origin.device_time, 100ms);
}

TEST(XsensImuDriver, AGroupOfWhichAFrameIsLostNeverMixesWithTheNext) {
  const std::vector<wire::CanFrame> group{ticks(0), counter(0), rate, force};
  for (std::size_t lost = 0; lost < 2 * group.size(); ++lost) {
    Bus bus;
    for (std::size_t i = 0; i < 3 * group.size(); ++i) {
      if (i == lost) continue;
      auto frame = group[i % 4];
      const auto g = static_cast<std::uint8_t>(i / 4);
      // Both vectors of a group contain its number.
      frame.data[frame.id == sample_time ? 3 : 1] = g;
      bus.says(frame, at_s(1 + 0.01 * g + 0.0004 * static_cast<double>(i % 4)));
    }
    for (const ImuSample& s : bus.samples()) {
      EXPECT_EQ(s.angular_rate.x() * 512, s.specific_force.x() * 256 - 256) << lost;
    }
    EXPECT_GE(bus.samples().size(), 2U) << lost;
  }
}

TEST(XsensImuDriver, TheLastOfOneGroupAndTheFirstOfALaterOneAreNotJoined) {
  Bus bus;
  bus.says({ticks(0), counter(0), rate}, 1);  // then nothing arrives for a second
  bus.says(force, at_s(2));
  EXPECT_TRUE(bus.samples().empty());
  bus.says({ticks(10'000), counter(100), rate, force}, 2.01);
  EXPECT_EQ(bus.samples().size(), 1U);
}

/// A busy host reads the acceleration 25 ms late, and what waited behind it together with it.
TEST(XsensImuDriver, DataThatWereReadFarApartAreASampleIfTheDevicesCountGoesOn) {
  for (const bool counted : {true, false}) {
    Bus bus;
    const auto marked = [&](unsigned group, double at) {
      if (counted)
        bus.says({counter(group), rate}, at);
      else
        bus.says({ticks(100 * group), rate}, at);
    };
    for (unsigned i = 0; i < 3; ++i) {
      marked(i, 1 + 0.01 * i);
      bus.says(force, at_s(1.0008 + 0.01 * i));
    }
    marked(3, 1.03);
    bus.says(force, at_s(1.055));
    EXPECT_EQ(bus.samples().size(), 3U) << "the fourth waits for the fifth";
    marked(4, 1.0551);
    bus.says(force, at_s(1.056));
    ASSERT_EQ(bus.samples().size(), 5U) << (counted ? "counter" : "ticks");
    EXPECT_EQ(bus.samples()[3].origin.received_at, at_s(1.055));
    EXPECT_LT(bus.samples()[3].origin.valid_at, at_s(1.031));
  }
}

TEST(XsensImuDriver, DataFarApartAreNoneIfAGroupIsMissing) {
  for (const bool counted : {true, false}) {
    Bus bus;
    const auto mark = [&](unsigned group) { return counted ? counter(group) : ticks(100 * group); };
    for (unsigned i = 0; i < 3; ++i) bus.says({mark(i), rate, force}, 1 + 0.01 * i);
    bus.says({mark(3), rate}, 1.03);
    bus.says(force, at_s(1.0408));  // of the next group, whose beginning was lost
    bus.says({mark(5), rate, force}, 1.05);
    EXPECT_EQ(bus.samples().size(), 4U) << (counted ? "counter" : "ticks");
  }
}

TEST(XsensImuDriver, WithoutSampleTimeAndCounterOnlyTimeJoins) {
  Bus bus;
  bus.says({rate, force}, 1);
  bus.says({rate}, 1.01);
  bus.says({force}, 1.02);
  bus.says({rate}, 1.03);
  bus.says({force}, 1.0301);
  EXPECT_EQ(bus.samples().size(), 2U);
  EXPECT_FALSE(bus.samples()[0].origin.device_time);
}

TEST(XsensImuDriver, TheDevicesTicksTakeTheJitterOfTheBusOut) {
  Bus bus;
  for (unsigned i = 0; i < 100; ++i) {
    const double late = i % 3 == 0 ? 0 : 0.0007 * (i % 3);  // frames of other nodes come first
    bus.says({ticks(100 * i), rate, force}, 1 + 0.01 * i + late);
  }
  ASSERT_EQ(bus.samples().size(), 100U);
  for (unsigned i = 0; i < 100; ++i) {
    const auto off = bus.samples()[i].origin.valid_at - (at_s(1 + 0.01 * i) - 304us);
    EXPECT_LE(std::chrono::abs(off), 5us) << i;
  }
}

TEST(XsensImuDriver, TheTickCounterMayWrap) {
  Bus bus;
  bus.says({ticks(0xFFFFFF9C), rate, force}, 1);  // 100 ticks before the wrap
  bus.says({ticks(0x00000000), rate, force}, 1.01);
  bus.says({ticks(0x00000064), rate, force}, 1.02);
  ASSERT_EQ(bus.samples().size(), 3U);
  EXPECT_EQ(*bus.samples()[2].origin.device_time - *bus.samples()[0].origin.device_time, 20ms);
  EXPECT_EQ(bus.samples()[2].origin.valid_at, at_s(1.02) - 304us);
}

TEST(XsensImuDriver, ADeviceThatRestartsIsTimedAnew) {
  Bus bus;
  bus.says({ticks(5'000'000), rate, force}, 1);
  bus.says({ticks(12), rate, force}, 9);
  ASSERT_EQ(bus.samples().size(), 2U);
  EXPECT_EQ(bus.samples()[1].origin.valid_at, at_s(9) - 304us);
  EXPECT_EQ(bus.samples()[1].origin.device_time, 1200us);
}

TEST(XsensImuDriver, AClippedGroupGivesNoSampleAndIsReportedOnce) {
  Bus bus;
  bus.says({ticks(0), status(0x103), rate, force}, 1);  // clipped acceleration x
  bus.says({ticks(100), status(0x103), rate, force}, 1.01);
  EXPECT_TRUE(bus.samples().empty());
  bus.says({ticks(200), status(0x003), rate, force}, 1.02);
  EXPECT_EQ(bus.samples().size(), 1U);
  EXPECT_EQ(bus.ear.reports,
            std::vector<std::string>{"acceleration or rate beyond the IMU's range"});
}

TEST(XsensImuDriver, AFailedSelfTestAndDroppedMessagesAreReported) {
  Bus bus;
  bus.says({status(0x2), status(0x2)}, 1);
  bus.says({can_frame(0x001, false, {1})}, 2);
  ASSERT_EQ(bus.ear.reports.size(), 2U);
  EXPECT_EQ(bus.ear.reports[0], "the IMU failed its self-test");
}

TEST(XsensImuDriver, TheHighRatePairCountsWhileThePlainOneDoesNotCome) {
  auto hr_rate = rate, hr_force = force;
  hr_rate.id = 0x061, hr_force.id = 0x062;
  Bus bus;
  bus.says({hr_rate, hr_force}, 1);
  EXPECT_EQ(bus.samples().size(), 1U);
  bus.says({rate, force}, 1.01);
  bus.says({hr_rate, hr_force}, 1.02);
  EXPECT_EQ(bus.samples().size(), 2U);
}

TEST(XsensImuDriver, IdentifiersAreThoseOfTheRig) {
  auto o = options(Kind::imu, "xsens");
  o.xsens_identifiers.extended = true;
  for (auto& id : o.xsens_identifiers.ids) id |= 0x19FF0000;
  Bus bus(o);
  bus.says({rate, force}, 1);
  EXPECT_TRUE(bus.samples().empty());
  auto long_rate = rate, long_force = force;
  long_rate.id |= 0x19FF0000, long_force.id |= 0x19FF0000;
  long_rate.extended = long_force.extended = true;
  bus.says({long_rate, long_force}, 2);
  EXPECT_EQ(bus.samples().size(), 1U);
}

}  // namespace xsens_imu_driver_test
}  // namespace drydock::device::test
