#include "drivers/wire/mavlink/mavlink.hpp"

#include <gtest/gtest.h>

#include "drivers/wire/mavlink/mavlink_layout.hpp"
#include "tests/drivers/property.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

namespace drydock::wire::testing {
namespace mavlink_test {

using namespace mavlink;
using std::chrono::microseconds;
using std::chrono::nanoseconds;

/// The frames of fixtures/mavlink/NOTE.md.
Reading<Mavlink> golden() { return read_stream<Mavlink>(fixture("mavlink/golden.mavlink")); }

Buffer encoded(const Mavlink::Message& message) {
  Buffer frame(Mavlink::max_frame);
  frame.resize(encode(message, frame));
  return frame;
}

/// As make_golden.cjs has it.
VisionPositionDelta golden_delta() {
  return {.sender = {1, 197, 250},
          .time = microseconds{1700000000123456},
          .time_delta = microseconds{125000},
          .angle_rad = {0.5F, -0.25F, 0.125F},
          .position_m = {1.5F, -0.75F, 0.0625F},
          .confidence = 62.5F};
}

Odometry golden_odometry() {
  Odometry m{.sender = {1, 197, 251},
             .time = microseconds{1700000000250000},
             .position_m = {1, 2, 3},
             .attitude = {0.5F, 0.5F, -0.5F, 0.5F},
             .velocity_mps = {-1.25F, 0.5F, 0.25F},
             .rates_radps = {0.1875F, -0.375F, 0.75F},
             .reset_counter = 7,
             .estimator_type = 2,
             .quality = -1};
  for (std::size_t i = 0; i < 21; ++i) {
    m.pose_covariance[i] = static_cast<float>(i + 1);
    m.velocity_covariance[i] = static_cast<float>(i + 1) / 64;
  }
  return m;
}

// CRC RevEng catalogue: the check value of CRC-16/MCRF4XX.
TEST(Mavlink, ItsChecksumIsThatOfTheCatalogue) {
  EXPECT_EQ(checksum(as_bytes("123456789")), 0x6F91U);
}

// The CRC_EXTRA tables of the MAVLink project's own headers.
TEST(Mavlink, TheSeedOfEachMessageFollowsFromItsDefinition) {
  EXPECT_EQ(crc_extra_of<Heartbeat>(), 50);
  EXPECT_EQ(crc_extra_of<Timesync>(), 34);
  EXPECT_EQ(crc_extra_of<Odometry>(), 91);
  EXPECT_EQ(crc_extra_of<VisionPositionDelta>(), 106);
}

TEST(Mavlink, EveryFieldOfAnotherLibrarysFramesIsRead) {
  const auto read = golden();
  const auto delta = read.all<VisionPositionDelta>().at(0);
  const auto wanted = golden_delta();
  EXPECT_EQ(delta.sender, wanted.sender);
  EXPECT_EQ(delta.time, wanted.time);
  EXPECT_EQ(delta.time_delta, wanted.time_delta);
  EXPECT_EQ(delta.angle_rad, wanted.angle_rad);
  EXPECT_EQ(delta.position_m, wanted.position_m);
  EXPECT_EQ(delta.confidence, wanted.confidence);

  const auto odometry = read.all<Odometry>().at(0);
  const auto all = golden_odometry();
  EXPECT_EQ(odometry.sender, all.sender);
  EXPECT_EQ(odometry.time, all.time);
  EXPECT_EQ(odometry.position_m, all.position_m);
  EXPECT_EQ(odometry.attitude, all.attitude);
  EXPECT_EQ(odometry.velocity_mps, all.velocity_mps);
  EXPECT_EQ(odometry.rates_radps, all.rates_radps);
  EXPECT_EQ(odometry.pose_covariance, all.pose_covariance);
  EXPECT_EQ(odometry.velocity_covariance, all.velocity_covariance);
  EXPECT_EQ(odometry.frame, 20);        // MAV_FRAME_LOCAL_FRD
  EXPECT_EQ(odometry.child_frame, 12);  // MAV_FRAME_BODY_FRD
  EXPECT_EQ(odometry.reset_counter, 7);
  EXPECT_EQ(odometry.estimator_type, 2);
  EXPECT_EQ(odometry.quality, -1);

  const auto question = read.all<Timesync>().at(0);
  EXPECT_EQ(question.tc1, nanoseconds{0});
  EXPECT_EQ(question.ts1, nanoseconds{1234567890123});
}

TEST(Mavlink, AHeartbeatIsReadFromBothVersionsAndWithASignature) {
  const auto beats = golden().all<Heartbeat>();
  ASSERT_EQ(beats.size(), 3U);
  EXPECT_EQ(beats[0].sender, (Sender{1, 1, 0}));
  EXPECT_EQ(beats[1].sender, (Sender{1, 1, 5}));
  EXPECT_EQ(beats[2].sender, (Sender{1, 1, 6}));
  for (const auto& beat : beats) {
    EXPECT_EQ(beat.vehicle, 12);   // MAV_TYPE_SUBMARINE
    EXPECT_EQ(beat.autopilot, 3);  // MAV_AUTOPILOT_ARDUPILOTMEGA
    EXPECT_EQ(beat.base_mode, 81);
    EXPECT_EQ(beat.custom_mode, 19U);
    EXPECT_EQ(beat.system_status, 4);
  }
}

TEST(Mavlink, AKindThatIsNotReadIsPassedOverAndNothingBehindItIsLost) {
  const auto read = golden();
  EXPECT_EQ(read.frames.size(), 7U);
  EXPECT_EQ(read.counters.bad_checksums, 0U);
  EXPECT_EQ(read.counters.bytes_skipped, 10U + 20U + 2U);  // ATTITUDE without its last zeros
}

TEST(Mavlink, WhatIsWrittenIsByteForByteTheOtherLibrarysFrame) {
  const auto frames = golden().frames;
  const Mavlink::Message question =
      Timesync{.sender = {1, 1, 1}, .ts1 = nanoseconds{1234567890123}};
  EXPECT_EQ(encoded(question), frames.at(1));
  EXPECT_EQ(encoded(golden_delta()), frames.at(2));
  EXPECT_EQ(encoded(golden_odometry()), frames.at(3));
}

// MAVLink developer guide, payload truncation: the first byte of a payload is never cut off.
TEST(Mavlink, APayloadOfZerosKeepsItsFirstByte) {
  const Buffer frame = encoded(VisionPositionDelta{});
  ASSERT_EQ(frame.size(), 13U);
  EXPECT_EQ(frame[1], 1);
  EXPECT_EQ(read_stream<Mavlink>(frame).frames.size(), 1U);
}

TEST(Mavlink, AFlagThatNobodyKnowsMakesAFrameUnreadable) {
  Buffer frame = encoded(golden_delta());
  frame[2] = 2;
  EXPECT_EQ(Mavlink::scan(frame), Scan::skip(1));
}

TEST(Mavlink, ALittleRoomWritesNothing) {
  std::array<std::uint8_t, 55> room{};
  EXPECT_EQ(encode(golden_delta(), room), 0U);
}

TEST(Mavlink, FramesComeOutOfAnyPieces) {
  const Buffer stream = fixture("mavlink/golden.mavlink");
  const auto whole = golden().frames;
  EXPECT_TRUE(holds([&] {
    const auto pieces = *rc::gen::nonEmpty(
        rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(1, 40)));
    RC_ASSERT((read_stream<Mavlink>(stream, pieces).frames == whole));
  }));
}

/// A CRC of 16 bits finds every error of one bit.
TEST(Mavlink, OneWrongBitIsNeverAMessage) {
  const Buffer sound = encoded(golden_odometry());
  for (std::size_t bit = 0; bit < sound.size() * 8; ++bit) {
    Buffer frame = sound;
    frame[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
    EXPECT_TRUE(read_stream<Mavlink>(frame).messages.empty()) << bit;
  }
}

TEST(Mavlink, AnyBytesAreReadWithoutHarmAndAllAreCounted) {
  EXPECT_TRUE(holds([] {
    auto noise = *rc::gen::arbitrary<Buffer>();
    if (!noise.empty()) noise[0] = *rc::gen::element<std::uint8_t>(0xFD, 0xFE, noise[0]);
    Mavlink::decode(noise);
    const auto read = read_stream<Mavlink>(noise);
    RC_ASSERT(read.counters.bytes_in ==
              read.counters.bytes_good + read.counters.bytes_skipped + read.held);
  }));
}

}  // namespace mavlink_test
}  // namespace drydock::wire::testing
