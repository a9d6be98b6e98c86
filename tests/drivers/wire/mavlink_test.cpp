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

// The values of fixtures/mavlink/make_autopilot.cjs.
TEST(Mavlink, WhatAnAutopilotSaysIsReadFromAnotherLibrarysFrames) {
  const auto read = read_stream<Mavlink>(fixture("mavlink/autopilot.mavlink"));
  EXPECT_EQ(read.counters.bytes_skipped, 0U);
  const auto time = read.all<SystemTime>().at(0);
  EXPECT_EQ(time.time_unix, microseconds{1700000000500000});
  EXPECT_EQ(time.time, milliseconds{61000});
  const auto gps = read.all<GpsRawInt>().at(0);
  EXPECT_EQ(gps.sender, (Sender{1, 1, 11}));
  EXPECT_EQ(gps.latitude_e7, 338103130);
  EXPECT_EQ(gps.longitude_e7, -1183938670);
  EXPECT_EQ(gps.height_mm, -1250);
  EXPECT_EQ(gps.speed_cmps, 123);
  EXPECT_EQ(gps.course_cdeg, 27012);
  EXPECT_EQ(gps.fix_type, 3);
  EXPECT_EQ(gps.satellites, 9);
  EXPECT_EQ(gps.ellipsoidal_height_mm, 33750);
  EXPECT_EQ(gps.horizontal_accuracy_mm, 707U);
  EXPECT_EQ(gps.heading_accuracy_e5, 150000U);
  EXPECT_EQ(gps.yaw_cdeg, 36000);
  const auto pressure = read.all<ScaledPressure>().at(0);
  EXPECT_EQ(pressure.absolute_hpa, 1513.25F);
  EXPECT_EQ(pressure.temperature_cdegc, 1234);
  EXPECT_EQ(pressure.differential_temperature_cdegc, -7);
  const auto local = read.all<LocalPositionNed>().at(0);
  EXPECT_EQ(local.position_m, (std::array{1.5F, -2.25F, 5.0F}));
  EXPECT_EQ(local.velocity_mps, (std::array{0.5F, -0.25F, 0.125F}));
  const auto global = read.all<GlobalPositionInt>().at(0);
  EXPECT_EQ(global.height_above_home_mm, -5000);
  EXPECT_EQ(global.east_cmps, -25);
  EXPECT_EQ(global.heading_cdeg, 27001);
  const auto hud = read.all<VfrHud>().at(0);
  EXPECT_EQ(hud.ground_speed_mps, 1.5F);
  EXPECT_EQ(hud.heading_deg, 270);
  EXPECT_EQ(hud.throttle_percent, 55);
  const auto range = read.all<DistanceSensor>().at(0);
  EXPECT_EQ(range.distance_cm, 4512);
  EXPECT_EQ(range.orientation, 25);
  EXPECT_EQ(range.attitude, (std::array{1.0F, 0.5F, 0.25F, 0.125F}));
  EXPECT_EQ(range.quality_percent, 87);
  const auto text = read.all<StatusText>().at(0);
  EXPECT_EQ(text.severity, 6);
  EXPECT_STREQ(text.text.data(), "EKF3 IMU0 origin set");
}

TEST(Mavlink, AKindThatIsNotReadIsAFrameWithItsNameAndNoMessage) {
  const auto read = read_stream<Mavlink>(fixture("mavlink/autopilot.mavlink"));
  ASSERT_EQ(read.frames.size(), 9U);
  EXPECT_EQ(read.messages.size(), 8U);
  EXPECT_EQ(Mavlink::frame_name(read.frames.back()), "MAVLink RAW_IMU");
}

TEST(Mavlink, AKindThatNobodyNamesIsNoise) {
  Buffer stream = encoded(golden_delta());
  stream[7] = stream[8] = stream[9] = 0xEE;
  const Buffer sound = encoded(golden_odometry());
  stream.insert(stream.end(), sound.begin(), sound.end());
  const auto read = read_stream<Mavlink>(stream);
  ASSERT_EQ(read.frames.size(), 1U);
  EXPECT_EQ(read.frames[0], sound);
}

TEST(Mavlink, WhatIsWrittenIsByteForByteTheOtherLibrarysFrame) {
  const auto frames = golden().frames;
  const Mavlink::Message question =
      Timesync{.sender = {1, 1, 1}, .ts1 = nanoseconds{1234567890123}};
  EXPECT_EQ(encoded(question), frames.at(1));
  EXPECT_EQ(encoded(golden_delta()), frames.at(3));
  EXPECT_EQ(encoded(golden_odometry()), frames.at(4));
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
