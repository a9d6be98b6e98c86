// Estimators on the bus in step with virtual time, as ROS 2 nodes with sim time are.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <functional>
#include <thread>

#include "drivers/bus/configuration.hpp"
#include "drivers/bus/reader.hpp"
#include "drivers/bus/writer.hpp"
#include "drivers/process/child.hpp"
#include "tests/hil/outside/outside_rig.hpp"
#include "tests/own_domain.hpp"

namespace clock_test {

using namespace drydock;
using outside_rig::Folder;
using testing::HasSubstr;

struct Run {
  summary::Summary summary;
  std::string said;
  const pipeline::PeerAccount& program() const { return *summary.estimators.at(0).program; }
  const summary::Verdict& verdict() const { return summary.verdicts.at(0); }
};

/// Five seconds of a rig whose estimator publishes /my/attitude.
Run in_step(const std::string& more = {}) {
  const Folder folder;
  std::string text = outside_rig::one_imu;
  text.insert(text.find("name = \"outside\"\n"),
              "dds_domain = " + std::to_string(test::own_domain()) + "\n");
  std::ofstream(folder / "rig.toml")
      << text << "[[estimator]]\nname = \"mine\"\nkind = \"external\"\nimu = \"imu\"\n"
      << "gives = \"attitude\"\ntopic = \"/my/attitude\"\nmessage = \"imu\"\n"
      << more;
  const auto rig = rig_config::load_rig(folder / "rig.toml").value();
  bench::RunOptions options;
  options.duration_s = 5;
  testing::internal::CaptureStdout();
  Run run;
  run.summary = bench::run_lockstep(rig, options);
  run.said = testing::internal::GetCapturedStdout();
  EXPECT_EQ(run.summary.duration_s, 5) << "no hang, and the bench goes on";
  EXPECT_EQ(run.verdict().what, "answers");
  return run;
}

/// A configuration of DDS in which readers acknowledge after 2 ms, for as long as it lives.
class QuickAcknowledgement {
 public:
  QuickAcknowledgement() : text_(bus::cyclone_configuration("lo")) {
    text_.insert(text_.find("</Domain>"),
                 "<Internal><HeartbeatInterval minsched=\"1 ms\" min=\"1 ms\" max=\"1 s\">2 ms"
                 "</HeartbeatInterval></Internal>");
    ::setenv("CYCLONEDDS_URI", text_.c_str(), 1);
  }
  ~QuickAcknowledgement() { ::unsetenv("CYCLONEDDS_URI"); }
  QuickAcknowledgement(const QuickAcknowledgement&) = delete;
  QuickAcknowledgement& operator=(const QuickAcknowledgement&) = delete;
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// The client of docs/build/external-estimator.md, in a process of its own.
Run with_the_client() {
  const QuickAcknowledgement quick;
  process::Child client({"env", "CYCLONEDDS_URI=" + quick.text(), DRYDOCK_CLOCK_ESTIMATOR,
                         "rt/imu/data", "rt/my/attitude", std::to_string(test::own_domain())},
                        "");
  return in_step();
}

TEST(OutsideOnTheClock, TwoRunsAreTheSameToTheLastBit) {
  const auto first = with_the_client(), second = with_the_client();
  EXPECT_TRUE(first.verdict().passed) << first.verdict().measured;
  EXPECT_EQ(first.program().answers, first.program().steps);
  EXPECT_GE(first.program().steps, 95U);
  EXPECT_LE(first.program().steps, 101U) << "5 s of 50 ms";
  EXPECT_EQ(first.summary.estimators.at(0).estimates, first.program().steps);
  ASSERT_GT(first.summary.traces.at(0).roll_deg.size(), 50U);
  EXPECT_EQ(first.summary.traces[0].roll_deg, second.summary.traces.at(0).roll_deg);
  EXPECT_EQ(first.summary.traces[0].pitch_deg, second.summary.traces[0].pitch_deg);
}

// A level vehicle on a straight path: gravity alone says roll and pitch.
TEST(OutsideOnTheClock, TheClientHearsTheMeasurementsOfItsStep) {
  const auto run = with_the_client();
  ASSERT_TRUE(run.summary.estimators.at(0).whole_run);
  EXPECT_LT(run.summary.estimators[0].whole_run->roll_max_deg, 0.2);
  EXPECT_LT(run.summary.estimators[0].whole_run->pitch_max_deg, 0.2);
}

/// A node of this process that does with the `n`-th clock, from 1 on, what `act` says. It is gone
/// when that is false.
class Node {
 public:
  using Writer = bus::Writer<bus::ImuMessage>;
  using Act = std::function<bool(Writer& writer, int n)>;

  explicit Node(Act act) : thread_([this, act = std::move(act)] { live(act); }) {}
  ~Node() {
    stopped_ = true;
    thread_.join();
  }

 private:
  void live(const Act& act) {
    const bus::Participant participant(test::own_domain(), "lo");
    Writer writer(participant, "rt/my/attitude", "base_link");
    bus::Doorbell bell;
    bus::Reader<bus::ClockMessage> clock(participant, "rt/clock", bell);
    for (int n = 0; !stopped_;) {
      pollfd rung{bell.fd(), POLLIN, 0};
      ::poll(&rung, 1, 10);
      bell.silence();
      bool stays = true;
      clock.drain([&](const bus::ClockMessage& message, const dds_sample_info_t&) {
        writer.message().header.stamp = message.clock;
        writer.message().orientation = {0, 0, 0, 1};
        stays = stays && act(writer, ++n);
      });
      if (!stays) return;
    }
  }

  std::atomic<bool> stopped_ = false;
  std::thread thread_;
};

bool say(Node::Writer& writer) {
  writer.write({});
  return true;
}

TEST(OutsideOnTheClock, ANodeThatHangsIsGivenUpAndSaid) {
  const Node node([](auto& writer, int n) { return n >= 10 || say(writer); });
  const auto run = in_step("answer_within_s = 0.2\n");
  EXPECT_FALSE(run.verdict().passed);
  EXPECT_EQ(run.program().failure, "did not answer within 1 s at 0.450 s");
  EXPECT_THAT(run.said, HasSubstr("did not answer within 1 s"));
  EXPECT_EQ(run.program().answers, 9U);
  EXPECT_EQ(run.program().steps, 10U);
}

TEST(OutsideOnTheClock, ANodeThatDiesHasLeftTheBus) {
  const Node node([](auto& writer, int n) { return n < 10 && say(writer); });
  const auto run = in_step();
  EXPECT_FALSE(run.verdict().passed);
  EXPECT_EQ(run.program().failure, "left the bus at 0.450 s");
  EXPECT_EQ(run.program().answers, 9U);
}

TEST(OutsideOnTheClock, ALateAnswerIsUsedAndCounted) {
  const Node node([](auto& writer, int n) {
    if (n == 5) ::poll(nullptr, 0, 300);
    return say(writer);
  });
  const auto run = in_step("answer_within_s = 0.2\n");
  EXPECT_FALSE(run.verdict().passed);
  EXPECT_EQ(run.program().late, 1U);
  EXPECT_EQ(run.program().answers, run.program().steps);
  EXPECT_EQ(run.summary.estimators.at(0).estimates, run.program().steps);
}

TEST(OutsideOnTheClock, ASecondAnswerIsNotUsed) {
  const Node node([](auto& writer, int) { return say(writer) && say(writer); });
  const auto run = in_step();
  EXPECT_FALSE(run.verdict().passed);
  EXPECT_GE(run.program().twice, run.program().steps - 1);
  EXPECT_EQ(run.summary.estimators.at(0).estimates, run.program().steps);
}

TEST(OutsideOnTheClock, NanIsTheAnswerOfItsStepAndNotUsed) {
  const Node node([](auto& writer, int n) {
    if (n == 3) writer.message().orientation.w = std::nan("");
    return say(writer);
  });
  const auto run = in_step();
  EXPECT_FALSE(run.verdict().passed);
  EXPECT_EQ(run.program().malformed, 1U);
  EXPECT_THAT(run.said, HasSubstr("sent a message that is no estimate"));
  EXPECT_EQ(run.program().answers, run.program().steps);
  EXPECT_EQ(run.summary.estimators.at(0).estimates, run.program().steps - 1);
}

TEST(OutsideOnTheClock, AnEstimateOfTheFutureIsNotUsed) {
  const Node node([](auto& writer, int n) {
    const auto stamp = writer.message().header.stamp;
    writer.message().header.stamp.sec += n == 3 ? 1 : 0;
    if (n == 3) say(writer);
    writer.message().header.stamp = stamp;
    return say(writer);
  });
  const auto run = in_step();
  EXPECT_FALSE(run.verdict().passed);
  EXPECT_EQ(run.program().out_of_time, 1U);
  EXPECT_EQ(run.summary.estimators.at(0).estimates, run.program().steps);
}

TEST(OutsideOnTheClock, WithoutANodeTheRunSaysSoAndEnds) {
  const auto run = in_step();
  EXPECT_FALSE(run.verdict().passed);
  EXPECT_EQ(run.program().failure,
            "nobody hears /clock and publishes /my/attitude within 10 s at 0.000 s");
}

}  // namespace clock_test
