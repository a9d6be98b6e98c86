#include "drivers/device/timing.hpp"

#include "tests/drivers/device/support.hpp"

namespace drydock::device::test {
namespace timing_test {

using std::chrono::nanoseconds;

DriverOptions log_at(unsigned baud, double latency_s = 0) {
  DriverOptions o = options(Kind::emlog, "nmea0183");
  o.baud = baud;
  o.latency = from_seconds(latency_s);
  return o;
}

/// A VHW sentence of exactly 40 bytes: 1 + body + 5.
Octets forty_bytes() {
  Octets sentence = nmea("VMVHW,045.0,T,043.00,M,03.50,N,06.");
  EXPECT_EQ(sentence.size(), 40U);
  return sentence;
}

TEST(Timing, FortyBytesAt4800BaudTake83Milliseconds) {
  Ear ear;
  byte_driver(log_at(4800))->receive(forty_bytes(), at_s(1), ear);
  const auto speeds = ear.all<measurement::WaterSpeed>();
  ASSERT_EQ(speeds.size(), 1U);
  EXPECT_EQ(speeds[0].origin.received_at, at_s(1));
  EXPECT_EQ(speeds[0].origin.valid_at, at_s(1) - nanoseconds{83'333'333});
}

// 40 bytes * 12 bits / 4800 bit/s
TEST(Timing, FortyBytesOf8E2At4800BaudTake100Milliseconds) {
  Ear ear;
  auto options = log_at(4800);
  options.byte_frame = {8, wire::Parity::even, 2};
  byte_driver(options)->receive(forty_bytes(), at_s(1), ear);
  EXPECT_EQ(ear.all<measurement::WaterSpeed>().at(0).origin.valid_at,
            at_s(1) - nanoseconds{100'000'000});
}

TEST(Timing, StatedLatencyIsSubtractedToo) {
  Ear ear;
  byte_driver(log_at(4800, 0.1))->receive(forty_bytes(), at_s(1), ear);
  EXPECT_EQ(ear.all<measurement::WaterSpeed>().at(0).origin.valid_at,
            at_s(1) - nanoseconds{183'333'333});
}

TEST(Timing, FrameInPiecesCountsFromItsLastByte) {
  Ear ear;
  const auto driver = byte_driver(log_at(4800));
  const Octets sentence = forty_bytes();
  for (std::size_t i = 0; i < sentence.size(); ++i) {
    driver->receive({&sentence[i], 1}, at_s(1 + 0.01 * static_cast<double>(i)), ear);
  }
  const auto origin = ear.all<measurement::WaterSpeed>().at(0).origin;
  EXPECT_EQ(origin.received_at, at_s(1.39));
  EXPECT_EQ(origin.valid_at, at_s(1.39) - nanoseconds{83'333'333});
}

TEST(Timing, FramesInOneReadArrivedOneAfterTheOther) {
  Ear ear;
  byte_driver(log_at(4800))->receive(forty_bytes() + forty_bytes() + forty_bytes(), at_s(1), ear);
  const auto speeds = ear.all<measurement::WaterSpeed>();
  ASSERT_EQ(speeds.size(), 3U);
  EXPECT_EQ(speeds[0].origin.received_at, at_s(1) - nanoseconds{166'666'666});
  EXPECT_EQ(speeds[1].origin.received_at, at_s(1) - nanoseconds{83'333'333});
  EXPECT_EQ(speeds[2].origin.received_at, at_s(1));
  EXPECT_NEAR(measurement::seconds(at_s(1) - speeds[0].origin.valid_at), 0.25, 2e-9);
}

/// A host that stood still reads in one moment what a line of 4800 baud carried in seconds.
TEST(Timing, WhatWaitedInAPortNeverGoesBackBehindWhatWasReadBefore) {
  Ear ear;
  const auto driver = byte_driver(log_at(4800));
  const Octets many = forty_bytes() + forty_bytes() + forty_bytes() + forty_bytes();
  driver->receive(many, at_s(10), ear);
  driver->receive(many, at_s(10.02), ear);
  const auto speeds = ear.all<measurement::WaterSpeed>();
  ASSERT_EQ(speeds.size(), 8U);
  for (std::size_t i = 1; i < speeds.size(); ++i) {
    EXPECT_GE(speeds[i].origin.received_at, speeds[i - 1].origin.received_at) << i;
    EXPECT_GE(speeds[i].origin.valid_at, speeds[i - 1].origin.valid_at) << i;
  }
  EXPECT_EQ(speeds[0].origin.received_at, at_s(10) - nanoseconds{250'000'000});
  EXPECT_EQ(speeds[7].origin.received_at, at_s(10.02));
}

TEST(Timing, AfterAClockThatWasSetBackTimesAreThoseOfTheClock) {
  Ear ear;
  const auto driver = byte_driver(log_at(4800));
  driver->receive(forty_bytes(), at_s(3610), ear);
  driver->receive(forty_bytes(), at_s(11), ear);
  EXPECT_EQ(ear.all<measurement::WaterSpeed>().at(1).origin.received_at, at_s(11));
}

TEST(Timing, LineWithoutABaudRateCostsOnlyTheLatency) {
  DriverOptions o = options(Kind::emlog, "nmea0183");
  o.latency = from_seconds(0.02);
  Ear ear;
  byte_driver(o)->receive(forty_bytes() + forty_bytes(), at_s(1), ear);
  const auto origin = ear.all<measurement::WaterSpeed>().at(0).origin;
  EXPECT_EQ(origin.received_at, at_s(1));
  EXPECT_EQ(origin.valid_at, at_s(0.98));
}

// The lengths from start to end of frame come from a bit-by-bit model of ISO 11898-1 in Python.
Stamp begin_of(const wire::CanFrame& frame) {
  const Origin origin = Timing(options(Kind::imu, "aceinna")).of_frame(at_s(1), frame);
  EXPECT_EQ(origin.received_at, at_s(1));
  return origin.valid_at;
}

TEST(Timing, AFrameWithoutRunsTakesItsPlainBits) {
  const auto frame = can_frame(0x0AAAAAAA, true, {0x55, 0x55, 0x55, 0x55, 0x55, 0x55, 0x55, 0x55});
  EXPECT_EQ(begin_of(frame), at_s(1) - nanoseconds{512'000});  // 64 + 8 x 8 bits of 4 us
}

TEST(Timing, AFrameOfRunsTakesItsStuffBitsToo) {
  EXPECT_EQ(begin_of(can_frame(0, false, {})), at_s(1) - 50 * nanoseconds{4000});
  EXPECT_EQ(begin_of(can_frame(0x181, false, {0, 0, 0, 0, 0, 0, 0, 0})),
            at_s(1) - 123 * nanoseconds{4000});
  EXPECT_EQ(begin_of(can_frame(0x08F02D80, true, {0, 0, 0, 0, 0, 0, 0, 0})),
            at_s(1) - 144 * nanoseconds{4000});
}

/// ISO 11898-1, 64 bytes and 11 bits at 500 kbit/s and 2 Mbit/s. Slow: 17 bits and 4 stuff bits, 1
/// delimiter, 2 of the acknowledgement, 7 of the end. Fast: 5 and 512 bits, 32 of CRC and stuff
/// count with their fixed stuff bits, and 129 stuff bits.
TEST(Timing, TheDataPhaseOfACanFdFrameHasItsOwnRate) {
  wire::CanFrame frame;
  frame.id = 0x123;
  frame.fd = frame.bit_rate_switch = true;
  frame.size = 64;
  DriverOptions o = options(Kind::depth, "nmea2000");
  o.bitrate = 500'000;
  o.data_bitrate = 2'000'000;
  EXPECT_EQ(Timing(o).line_time(frame), 31 * nanoseconds{2000} + 678 * nanoseconds{500});
  frame.bit_rate_switch = false;
  EXPECT_EQ(Timing(o).line_time(frame), (31 + 678) * nanoseconds{2000});
}

}  // namespace timing_test
}  // namespace drydock::device::test
