// Programs that steer the vehicle in step with virtual time: docs/world/steering-program.md
#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

#include "tests/hil/outside/outside_rig.hpp"

namespace steering_program_test {

using namespace outside_rig;
using testing::Contains;
using testing::HasSubstr;

const std::string holder = "[\"python3\", \"" DRYDOCK_SOURCE_DIR
                           "/docs/build/clients/depth_heading_client.py\", \"90\", \"5\"]";
const std::string nps = "vehicle = \"" DRYDOCK_SOURCE_DIR "/rig_config/vehicles/nps-auv-ii.toml\"";
const std::string rov = "vehicle = \"" DRYDOCK_SOURCE_DIR "/rig_config/vehicles/bluerov2.toml\"";
const std::string own = "[\"python3\", \"client.py\"]";

/// A program whose `answer` says what it says to each step: `step`, its number `n`, `say`.
std::string program(const std::string& answer) {
  return "import json, os, sys, time\n"
         "def say(said): print(json.dumps(said), flush=True)\n"
         "hello = json.loads(sys.stdin.readline())\n"
         "say({'drydock': 1})\n"
         "for line in sys.stdin:\n"
         "    step = json.loads(line)\n"
         "    n = step['step']\n"
         "    sail = [{'joint': 'propeller', 'velocity_radps': 150.0}]\n"
         "    " +
         answer + "\n";
}

struct Run {
  drydock::summary::Summary summary;
  std::string said;
  const drydock::summary::Verdict& verdict() const { return summary.verdicts.at(0); }
  /// The mean over the last seconds of the run.
  double end_of(const std::vector<double>& values, double seconds) const {
    const auto& t = summary.motion.t_s;
    std::vector<double> last;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (t[i] > t.back() - seconds) last.push_back(values[i]);
    return std::accumulate(last.begin(), last.end(), 0.0) / static_cast<double>(last.size());
  }
};

/// The sensors of the shipped rig "loop", and another mission.
Run sailed(const std::string& vehicle, const std::string& command, double seconds,
           const std::string& client = {}, const std::string& more = {},
           const std::string& faults = {}) {
  const Folder folder;
  std::ofstream(folder / "mission.toml")
      << "[mission]\nlatitude_deg = 36.0\nlongitude_deg = 129.0\ndepth_m = 3.0\n"
         "heading_deg = 30.0\n"
      << vehicle << "\n[steering]\nfrom = \"program\"\ncommand = " << command << "\n"
      << more << "\n[ocean]\nbed = { kind = \"plane\", depth_m = 60.0 }\n"
      << faults;
  std::ifstream in(DRYDOCK_SOURCE_DIR "/rig_config/rigs/loop.toml");
  std::string rig{std::istreambuf_iterator<char>(in), {}};
  const std::string old = "../missions/loop.toml";
  rig.replace(rig.find(old), old.size(), "mission.toml");
  if (vehicle == rov) rig.resize(rig.find("[[device]]\nname = \"rudder\""));
  Run run;
  run.summary = outside_rig::run(folder, rig, client, seconds, &run.said);
  EXPECT_EQ(run.summary.duration_s, seconds) << "no hang, and the bench goes on";
  EXPECT_EQ(run.verdict().subject, "steering");
  EXPECT_EQ(run.verdict().what, "answers");
  return run;
}

TEST(SteeringProgram, HoldsHeadingAndDepthOfAVehicleWithEquationsOfMotionAndOfAKinematicOne) {
  for (const auto& vehicle : {nps, std::string{}}) {
    const auto run = sailed(vehicle, holder, 400);
    EXPECT_TRUE(run.verdict().passed) << run.verdict().measured << run.said;
    EXPECT_NEAR(run.end_of(run.summary.motion.heading_deg, 20), 90, 1) << vehicle;
    EXPECT_NEAR(run.end_of(run.summary.motion.depth_m, 20), 5, 0.2) << vehicle;
    EXPECT_GT(run.end_of(run.summary.motion.speed_mps, 20), 1) << vehicle;
  }
}

TEST(SteeringProgram, TwoRunsAreTheSameToTheLastBit) {
  const auto first = sailed(nps, holder, 40), second = sailed(nps, holder, 40);
  ASSERT_GE(first.summary.motion.heading_deg.size(), 40u) << "one a second";
  EXPECT_EQ(first.summary.motion.heading_deg, second.summary.motion.heading_deg);
  EXPECT_EQ(first.summary.motion.depth_m, second.summary.motion.depth_m);
  EXPECT_EQ(first.summary.motion.north_m, second.summary.motion.north_m);
}

// The balance of JointHelm's tests: two thrusters push down with 15 N each, 2 N of buoyancy push
// up.
TEST(SteeringProgram, OrdersThrustersInNewtonsAndTheWholeBodyByAWrench) {
  const double push = 30 - 2;
  const double w = (-5.18 + std::sqrt(5.18 * 5.18 + 4 * 36.99 * push)) / (2 * 36.99);
  for (const std::string orders : {"'orders': [{'joint': 'vertical-' + side, 'effort_n': 15} for "
                                   "side in ('port', 'starboard')]",
                                   "'wrench': {'force_n': [0, 0, 30]}"}) {
    const auto run = sailed(rov, own, 30, program("say({'step': n, " + orders + "})"));
    EXPECT_TRUE(run.verdict().passed) << run.verdict().measured << run.said;
    const auto& t = run.summary.motion.t_s;
    const auto& depth = run.summary.motion.depth_m;
    const auto last = t.size() - 1, before = last - last / 3;
    EXPECT_NEAR((depth[last] - depth[before]) / (t[last] - t[before]), w, 0.005) << orders;
  }
}

TEST(SteeringProgram, IsToldTheTruthOnlyIfTheMissionSaysSo) {
  const auto without = sailed(
      nps, own, 2, program("os._exit(3) if 'truth' in step else say({'step': n, 'orders': sail})"));
  EXPECT_TRUE(without.verdict().passed) << without.verdict().measured;
  const auto with = sailed(
      nps, own, 2,
      program("os._exit(3) if abs(step['truth']['height_m'] + 3) > 0.1 or "
              "abs(step['truth']['heading_deg'] - 30) > 1 else say({'step': n, 'orders': sail})"),
      "truth = true");
  EXPECT_TRUE(with.verdict().passed) << with.verdict().measured;
}

TEST(SteeringProgram, ThatDiesIsSaidAndTheVehicleGoesToItsSafeState) {
  const auto run = sailed(nps, own, 120,
                          program("say({'step': n, 'orders': sail}) if n <= 600 else os._exit(7)"));
  EXPECT_FALSE(run.verdict().passed);
  EXPECT_THAT(run.verdict().measured,
              HasSubstr("600 to 601 steps; exited with code 7 at 30.000 s"));
  EXPECT_THAT(run.said, HasSubstr("30.000 s steering: its program exited with code 7"));
  EXPECT_THAT(run.said, HasSubstr("no order for propeller for 1 s: it goes to its safe state"));
  EXPECT_LT(run.end_of(run.summary.motion.speed_mps, 1), 0.6) << "its propeller has stopped";
}

TEST(SteeringProgram, ThatHangsIsKilledAndSaid) {
  const auto run = sailed(
      nps, own, 5, program("say({'step': n, 'orders': sail}) if n < 10 else time.sleep(1000)"),
      "answer_within_s = 0.2");
  EXPECT_FALSE(run.verdict().passed);
  EXPECT_THAT(run.said, HasSubstr("0.450 s steering: its program did not answer within 1 s"));
}

TEST(SteeringProgram, ThatAnswersLateIsFollowedAndCounted) {
  const auto run =
      sailed(nps, own, 5,
             program("(time.sleep(0.3) if n == 10 else None, say({'step': n, 'orders': sail}))"),
             "answer_within_s = 0.2");
  EXPECT_FALSE(run.verdict().passed);
  EXPECT_THAT(run.verdict().measured, HasSubstr("101 to 101 steps; 1 late"));
}

TEST(SteeringProgram, ThatOrdersNotANumberOrAnUnknownJointIsSaidAndNotFollowed) {
  const auto nan = sailed(nps, own, 5,
                          program("say({'step': n, 'orders': sail + [{'joint': 'rudder', "
                                  "'position_deg': float('nan')}]})"));
  EXPECT_FALSE(nan.verdict().passed);
  EXPECT_THAT(nan.verdict().measured, HasSubstr("101 not finite"));
  EXPECT_THAT(nan.said, HasSubstr("steering: its program answered with position_deg: NaN"));
  EXPECT_NEAR(nan.summary.motion.heading_deg.back(), 30, 1);
  const auto unknown =
      sailed(nps, own, 5,
             program("say({'step': n, 'orders': [{'joint': 'aileron', 'position_deg': 1}]})"));
  EXPECT_THAT(unknown.verdict().measured, HasSubstr("101 malformed"));
  EXPECT_THAT(unknown.said, HasSubstr("the joint aileron, allowed: rudder, stern_planes"));
}

TEST(SteeringProgram, ARunWithoutAnEndSaysThatItNeedsOne) {
  try {
    sailed(nps, own, 0, program("say({'step': n, 'orders': sail})"));
    FAIL() << "it ran for 0 s";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("rig.toml: its motion has no end of its own"));
  }
  testing::internal::GetCapturedStdout();
}

TEST(SteeringProgram, AStuckRudderDoesNotTurnTheVehicle) {
  const auto turn =
      program("say({'step': n, 'orders': sail + [{'joint': 'rudder', 'position_deg': 15.0}]})");
  const auto sound = sailed(nps, own, 30, turn);
  const auto stuck = sailed(nps, own, 30, turn, {},
                            "[[fault]]\ndevice = \"rudder\"\nfault = \"stuck\"\nstart_s = 0.0\n");
  EXPECT_TRUE(stuck.verdict().passed) << stuck.verdict().measured;
  EXPECT_GT(std::abs(std::remainder(sound.summary.motion.heading_deg.back() - 30, 360)), 15);
  EXPECT_NEAR(std::remainder(stuck.summary.motion.heading_deg.back() - 30, 360), 0, 2);
}

}  // namespace steering_program_test
