#include "hil/bridge/autopilot_feed.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "hil/bridge/feed_report.hpp"
#include "hil/bridge/motion_messages.hpp"

namespace drydock::bridge {
namespace autopilot_feed_test {

using Eigen::Vector3d;
using measurement::BottomVelocity;
using std::chrono::milliseconds;
using testing::ElementsAre;
using testing::HasSubstr;
using wire::mavlink::Heartbeat;
using wire::mavlink::Odometry;
using wire::mavlink::Timesync;
using wire::mavlink::VisionPositionDelta;

constexpr Stamp start{std::chrono::seconds{1'700'000'000}};

BottomVelocity ping(Stamp valid_at, std::optional<Vector3d> velocity = Vector3d(1, 0, 0)) {
  BottomVelocity result;
  result.origin.valid_at = valid_at;
  result.velocity = velocity;
  return result;
}

/// An autopilot that keeps what it gets, and a clock.
class Autopilot {
 public:
  explicit Autopilot(const FeedOptions& options = {})
      : feed(
            options,
            [this](wire::Bytes frame) {
              if (!takes) return false;
              got.push_back(wire::Mavlink::decode(frame).value());
              got_at.push_back(now);
              return true;
            },
            [this](std::string_view line) { lines.emplace_back(line); }) {}

  void hear(const BottomVelocity& heard, milliseconds age = milliseconds{30}) {
    now = heard.origin.valid_at + age;
    feed.on(heard, now);
  }
  /// Pings of a steady velocity, this many after `first`.
  void hear_many(Stamp first, int pings, milliseconds period) {
    for (int i = 0; i < pings; ++i) hear(ping(first + i * period));
  }
  template <class M>
  std::vector<M> all() const {
    std::vector<M> found;
    for (const auto& message : got)
      if (const auto* m = std::get_if<M>(&message)) found.push_back(*m);
    return found;
  }

  bool takes = true;
  Stamp now = start;
  std::vector<wire::Mavlink::Message> got;
  std::vector<Stamp> got_at;
  std::vector<std::string> lines;
  AutopilotFeed feed;
};

TEST(AutopilotFeed, SendsTheMotionSinceThePingBefore) {
  Autopilot autopilot;
  autopilot.hear_many(start, 3, milliseconds{125});
  const auto deltas = autopilot.all<VisionPositionDelta>();
  ASSERT_EQ(deltas.size(), 2U);
  EXPECT_EQ(deltas[1].time, std::chrono::microseconds{1'700'000'000'250'000});
  EXPECT_EQ(deltas[1].time_delta, milliseconds{125});
  EXPECT_FLOAT_EQ(deltas[1].position_m[0], 0.125F);
  EXPECT_EQ(deltas[1].sender.system, 1);
  EXPECT_EQ(deltas[1].sender.component, 197);
  EXPECT_EQ(deltas[1].sender.sequence, deltas[0].sender.sequence + 1);
  EXPECT_THAT(autopilot.lines, ElementsAre("the motion is sent"));
}

TEST(AutopilotFeed, SendsAtMostTwentyMessagesASecondAndLosesNoWay) {
  Autopilot autopilot;
  autopilot.hear_many(start, 501, milliseconds{20});
  const auto deltas = autopilot.all<VisionPositionDelta>();
  EXPECT_LE(deltas.size(), 201U);
  EXPECT_GE(deltas.size(), 190U);
  double way_m = 0;
  std::chrono::microseconds time{};
  for (const auto& delta : deltas) {
    way_m += delta.position_m[0];
    time += delta.time_delta;
  }
  EXPECT_NEAR(way_m, std::chrono::duration<double>(time).count(), 1e-3);  // 1 m/s
  EXPECT_NEAR(way_m, 10, 0.06);
}

TEST(AutopilotFeed, KeepsTheRateOfADvlOfTwentyHertzWhoseTelegramsComeUnevenly) {
  Autopilot autopilot;
  for (int i = 0; i < 200; ++i)
    autopilot.hear(ping(start + i * milliseconds{50}), milliseconds{i % 2 == 0 ? 30 : 45});
  EXPECT_EQ(autopilot.feed.counters().merged, 0U);
}

TEST(AutopilotFeed, GivesNothingWithoutBottomLockAndBeginsAnewBehindIt) {
  Autopilot autopilot;
  autopilot.hear_many(start, 2, milliseconds{125});
  for (int i = 2; i < 6; ++i) autopilot.hear(ping(start + i * milliseconds{125}, {}));
  EXPECT_EQ(autopilot.got.size(), 1U);
  autopilot.hear_many(start + milliseconds{750}, 2, milliseconds{125});
  const auto deltas = autopilot.all<VisionPositionDelta>();
  ASSERT_EQ(deltas.size(), 2U);
  EXPECT_EQ(deltas[1].time_delta, milliseconds{125}) << "the way without lock is not known";
  EXPECT_EQ(autopilot.feed.counters().no_velocity, 4U);
  EXPECT_THAT(autopilot.lines,
              ElementsAre("the motion is sent", "the DVL gives no velocity (no bottom lock)",
                          "the motion is sent"));
}

TEST(AutopilotFeed, SendsNothingThatIsOlderThanTwoHundredMilliseconds) {
  Autopilot autopilot;
  autopilot.hear(ping(start));
  autopilot.hear(ping(start + milliseconds{125}), milliseconds{200});
  EXPECT_EQ(autopilot.got.size(), 1U) << "200 ms are allowed";
  autopilot.hear(ping(start + milliseconds{250}), milliseconds{201});
  EXPECT_EQ(autopilot.got.size(), 1U);
  EXPECT_EQ(autopilot.feed.counters().old, 1U);
  EXPECT_THAT(autopilot.lines.back(), HasSubstr("more than 200 ms old"));
}

TEST(AutopilotFeed, BeginsAnewWhenTheDvlFellSilent) {
  Autopilot autopilot;
  autopilot.hear_many(start, 2, milliseconds{125});
  autopilot.feed.on_silence();
  autopilot.hear_many(start + milliseconds{250}, 1, milliseconds{125});
  EXPECT_EQ(autopilot.got.size(), 1U);
  EXPECT_EQ(autopilot.feed.counters().breaks, 1U);
  EXPECT_EQ(autopilot.lines.back(), "the DVL is silent");
}

TEST(AutopilotFeed, CountsWhatTheLinkDoesNotTakeAndKeepsNothingForLater) {
  Autopilot autopilot;
  autopilot.takes = false;
  autopilot.hear_many(start, 4, milliseconds{125});
  EXPECT_EQ(autopilot.feed.counters().not_taken, 3U);
  autopilot.takes = true;
  autopilot.hear_many(start + milliseconds{500}, 1, milliseconds{125});
  EXPECT_EQ(autopilot.all<VisionPositionDelta>().at(0).time_delta, milliseconds{125});
  EXPECT_EQ(autopilot.all<VisionPositionDelta>().at(0).sender.sequence, 0)
      << "a gap in the sequence would say that the link lost messages";
}

TEST(AutopilotFeed, TurnsWithTheImuOfTheRigAndWithNoOther) {
  FeedOptions options;
  options.imu = 4;
  Autopilot autopilot(options);
  for (int ms = 0; ms <= 300; ms += 10)
    for (const std::uint16_t device : {std::uint16_t{4}, std::uint16_t{5}}) {
      measurement::ImuSample sample;
      sample.origin.valid_at = start + milliseconds{ms};
      sample.origin.device = device;
      sample.angular_rate = Vector3d(0, 0, device == 4 ? 0.4 : 9);
      autopilot.feed.on(sample, start);
    }
  autopilot.hear_many(start, 2, milliseconds{250});
  EXPECT_NEAR(autopilot.all<VisionPositionDelta>().at(0).angle_rad[2], 0.1, 1e-6);
  EXPECT_EQ(autopilot.feed.counters().without_rotation, 0U);
}

TEST(AutopilotFeed, SendsOdometryWithWhatADvlKnowsAndNoPose) {
  FeedOptions options;
  options.position_delta = false;
  options.odometry = true;
  Autopilot autopilot(options);
  autopilot.hear(ping(start));
  auto last = ping(start + milliseconds{125}, Vector3d(0.5, -0.25, 0.125));
  last.velocity_covariance = Vector3d(0.01, 0.02, 0.03).asDiagonal();
  (*last.velocity_covariance)(0, 1) = (*last.velocity_covariance)(1, 0) = 0.005;
  autopilot.hear(last);
  const auto messages = autopilot.all<Odometry>();
  ASSERT_EQ(messages.size(), 1U);
  const auto& m = messages[0];
  EXPECT_EQ(m.velocity_mps, (std::array<float, 3>{0.5F, -0.25F, 0.125F}));
  // The upper triangle of 6 x 6: rows begin at 0, 6, 11, 15, 18, 20.
  EXPECT_FLOAT_EQ(m.velocity_covariance[0], 0.01F);
  EXPECT_FLOAT_EQ(m.velocity_covariance[1], 0.005F);
  EXPECT_FLOAT_EQ(m.velocity_covariance[6], 0.02F);
  EXPECT_FLOAT_EQ(m.velocity_covariance[11], 0.03F);
  EXPECT_TRUE(std::isnan(m.velocity_covariance[15]));
  EXPECT_TRUE(std::isnan(m.position_m[0]));
  EXPECT_TRUE(std::isnan(m.attitude[0]));
  EXPECT_TRUE(std::isnan(m.pose_covariance[0]));
  EXPECT_TRUE(std::isnan(m.rates_radps[2])) << "no IMU";
}

// ArduPilot, NavEKF3: error = VERR_MIN + (VERR_MAX - VERR_MIN) (1 - confidence / 100), by default
// 0.1 and 0.9 m/s.
TEST(AutopilotFeed, SaysAConfidenceFromWhichAnEkf3ReadsTheAccuracyBack) {
  for (const double sigma_mps : {0.1, 0.3, 0.5, 0.9})
    EXPECT_NEAR(0.1 + (0.9 - 0.1) * (1 - confidence_of(sigma_mps) / 100), sigma_mps, 1e-12);
  EXPECT_EQ(confidence_of(0.01), 100);
  EXPECT_EQ(confidence_of(5), 0);
}

TEST(AutopilotFeed, AnswersTheAutopilotsQuestionForTheTime) {
  Autopilot autopilot;
  std::array<std::uint8_t, wire::Mavlink::max_frame> frame;
  Timesync question;
  question.sender = {7, 1, 0};
  question.ts1 = std::chrono::nanoseconds{424242};
  const std::size_t size = wire::mavlink::encode(question, frame);
  autopilot.feed.receive(wire::Bytes{frame}.first(size), start + milliseconds{5});
  const auto answers = autopilot.all<Timesync>();
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(answers[0].ts1, std::chrono::nanoseconds{424242});
  EXPECT_EQ(answers[0].tc1, std::chrono::nanoseconds{1'700'000'000'005'000'000});
  EXPECT_EQ(answers[0].target_system, 7);
  EXPECT_EQ(answers[0].target_component, 1);
}

TEST(AutopilotFeed, HearsAnAutopilotButNoOtherComponent) {
  Autopilot autopilot;
  std::array<std::uint8_t, wire::Mavlink::max_frame> frame;
  for (const std::uint8_t kind : {Heartbeat::no_autopilot, std::uint8_t{3}, std::uint8_t{3}}) {
    Heartbeat beat;
    beat.autopilot = kind;
    const std::size_t size = wire::mavlink::encode(beat, frame);
    autopilot.feed.receive(wire::Bytes{frame}.first(size), start);
  }
  EXPECT_EQ(autopilot.feed.counters().autopilot_heartbeats, 2U);
  EXPECT_THAT(autopilot.lines, ElementsAre("the autopilot answers"));
}

// A mean velocity over 125 ms is that of 62.5 ms before its end, which is 30 ms old.
TEST(AutopilotFeed, TellsTheDelayThatTheAutopilotShouldTake) {
  Autopilot autopilot;
  autopilot.hear_many(start, 10, milliseconds{125});
  EXPECT_EQ(delay_of(autopilot.feed.counters()), std::chrono::microseconds{92'500});
  EXPECT_THAT(to_json(autopilot.feed.counters()), HasSubstr("\"delay_ms\":92.5"));
}

/// Byte 1 of a MAVLink 2 frame is the length of its payload.
TEST(AutopilotFeed, AnswersTheQuestionBehindADamagedLengthWithItsTime) {
  Autopilot autopilot;
  std::array<std::uint8_t, wire::Mavlink::max_frame> heartbeat, question;
  const std::size_t heartbeat_size = wire::mavlink::encode(Heartbeat{}, heartbeat);
  heartbeat[1] = static_cast<std::uint8_t>(heartbeat[1] ^ 1U << 7);
  Timesync asked;
  asked.ts1 = milliseconds{42};
  const std::size_t question_size = wire::mavlink::encode(asked, question);
  autopilot.feed.receive(wire::Bytes{heartbeat}.first(heartbeat_size), start);
  autopilot.feed.receive(wire::Bytes{question}.first(question_size), start + milliseconds{100});
  autopilot.feed.receive(wire::Bytes{question}.first(question_size), start + milliseconds{700});
  const auto answers = autopilot.all<Timesync>();
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0].tc1, (start + milliseconds{100}).time_since_epoch());
  EXPECT_EQ(answers[1].tc1, (start + milliseconds{700}).time_since_epoch());
}

}  // namespace autopilot_feed_test
}  // namespace drydock::bridge
