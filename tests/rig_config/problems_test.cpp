#include "tests/rig_config/problems.hpp"
#include "rig_config/estimator/kinds.hpp"

/// Rig files: keys, types, ranges.
namespace drydock::rig_config::test {
namespace problems_test {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(RigProblems, TheSmallestRigHasNone) { EXPECT_THAT(problems_of(""), IsEmpty()); }

TEST(RigProblems, AnUnknownKeyIsNamedWithTheAllowedOnesAndTheLikelyOne) {
  EXPECT_THAT(problems_of("colour = 5\n"),
              ElementsAre("r.toml:8:1: /device/0/colour: unknown key, allowed here: emulate, "
                          "kind, latency_ms, levelled, lever_arm_m, link, mounting_deg, name, "
                          "protocol, rate_hz, reopen_after_s, sound_speed, stale_after_s, "
                          "velocity_sigma_mps"));
  EXPECT_THAT(problems_of("rate_h = 5\n"),
              ElementsAre(HasSubstr("/device/0/rate_h: unknown key (did you mean 'rate_hz'?), ")));
}

TEST(RigProblems, AnUnknownTableIsAnUnknownKey) {
  EXPECT_THAT(problems_of("[[devices]]\n"),
              ElementsAre("r.toml:8:3: /devices: unknown key (did you mean 'device'?), allowed "
                          "here: device, estimator, expect, fault, rig"));
}

TEST(RigProblems, ATableOfAMissionIsToldItsFile) {
  for (const std::string table :
       {"mission", "steering", "ocean", "leg", "waypoint", "guidance", "ballistic", "track"})
    EXPECT_THAT(problems_of("[" + table + "]\nx = 1\n"),
                ElementsAre(AllOf(HasSubstr("/" + table + ": unknown key"),
                                  HasSubstr("[" + table +
                                            "] stands in the file that `mission` of "
                                            "[rig] names"))));
}

TEST(RigProblems, AMissingKeyIsReportedWhereItsTableBegins) {
  EXPECT_THAT(problems_of("[[device]]\nname = \"gnss\"\nkind = \"gnss\"\nprotocol = \"ubx\"\n"),
              ElementsAre("r.toml:8:1: /device/1: key 'link' is missing"));
}

TEST(RigProblems, AWrongChoiceIsToldTheAllowedOnes) {
  std::string kinds;
  for (const EstimatorFacts& facts : estimator_facts)
    kinds.append(kinds.empty() ? "" : ", ").append(facts.name);
  EXPECT_THAT(problems_of("[[estimator]]\nname = \"l\"\nkind = \"levelling\"\nimu = \"imu\"\n"
                          "model = \"stationary\"\n" +
                          std::string(imu_table)),
              ElementsAre("r.toml:10:8: /estimator/0/kind: \"levelling\" is not allowed (did you "
                          "mean 'leveling'?), allowed: " +
                          kinds));
}

TEST(RigProblems, AProtocolMustFitTheKind) {
  EXPECT_THAT(problems_of("[[device]]\nname = \"g\"\nkind = \"gnss\"\nprotocol = \"pd0\"\n"
                          "link = \"pty:g\"\n"),
              ElementsAre("r.toml:11:12: /device/1/protocol: \"pd0\" is not allowed, allowed: ubx, "
                          "nmea0183, ubx+nmea0183, nmea2000"));
}

TEST(RigProblems, AWrongTypeNamesBoth) {
  EXPECT_THAT(problems_of("rate_hz = \"5\"\n"),
              ElementsAre("r.toml:8:11: /device/0/rate_hz: expected a number, found a string"));
  EXPECT_THAT(problems_of("emulate = { velocity_bias_mps = true }\n"),
              ElementsAre("r.toml:8:33: /device/0/emulate/velocity_bias_mps: expected a number or "
                          "an array, found true or false"));
}

TEST(RigProblems, ANumberOutOfRangeIsToldTheRange) {
  EXPECT_THAT(
      problems_of("rate_hz = 0\n"),
      ElementsAre("r.toml:8:11: /device/0/rate_hz: 0 is out of range, allowed: 0.001 to 1000"));
  EXPECT_THAT(
      problems_of("[[device]]\nname = \"d\"\nkind = \"depth\"\nprotocol = \"nmea2000\"\n"
                  "link = \"can:auto\"\naddress = 254\n"),
      ElementsAre("r.toml:13:11: /device/1/address: 254 is out of range, allowed: 0 to 253"));
}

// Its period has no number of nanoseconds: an emulated device would never end its first tick.
TEST(RigProblems, ARateWithoutATimeBetweenSamplesIsRefused) {
  EXPECT_THAT(problems_of("rate_hz = 1e-300\n"),
              ElementsAre(testing::HasSubstr("is out of range, allowed: 0.001 to 1000")));
}

TEST(RigProblems, AVectorHasThreeComponents) {
  EXPECT_THAT(problems_of("lever_arm_m = [1, 2]\n"),
              ElementsAre("r.toml:8:15: /device/0/lever_arm_m: has 2 values, allowed: 3"));
  EXPECT_THAT(problems_of("mounting_deg = [0, 361, 0]\n"),
              ElementsAre("r.toml:8:20: /device/0/mounting_deg/1: 361 is out of range, allowed: "
                          "-360 to 360"));
}

TEST(RigProblems, NotANumberAndInfinityAreNoNumbers) {
  EXPECT_THAT(problems_of("rate_hz = nan\n"),
              ElementsAre("r.toml:8:11: /device/0/rate_hz: nan and inf are not allowed"));
}

TEST(RigProblems, AChoiceIsAString) {
  EXPECT_THAT(problems_of_text("[rig]\nname = \"r\"\n[[device]]\nname = \"d\"\nprotocol = \"pd0\"\n"
                               "link = \"pty:d\"\nkind = 2026-11-21T08:00:00Z\n"),
              ElementsAre("r.toml:7:8: /device/0/kind: expected one of: dvl, emlog, gnss, imu, "
                          "depth, actuator, attitude, found a date-time"));
}

TEST(RigProblems, ARigNeedsADevice) {
  EXPECT_THAT(problems_of_text("[rig]\nname = \"r\"\n"),
              ElementsAre("r.toml:1:1: /: key 'device' is missing"));
  EXPECT_THAT(problems_of_text("device = []\n[rig]\nname = \"r\"\n"),
              ElementsAre("r.toml:1:10: /device: has 0 values, allowed: 1 to 256"));
}

TEST(RigProblems, AllComeAtOnceInFileOrder) {
  const auto lines = problems_of_text(
      "[rig]\nnmae = \"r\"\nseed = -1\n[[device]]\nname = \"dvl\"\nkind = \"dvl\"\n"
      "protocol = \"pd0\"\nlink = \"\"\nrate_hz = -1\n[device.emulate]\ncolour = 1\n");
  EXPECT_THAT(lines, ElementsAre(HasSubstr("r.toml:1:1: /rig: key 'name' is missing"),
                                 HasSubstr("r.toml:2:1: /rig/nmae: unknown key"),
                                 HasSubstr("r.toml:3:8: /rig/seed: -1 is out of range"),
                                 HasSubstr("r.toml:8:8: /device/0/link: must not be empty"),
                                 HasSubstr("r.toml:9:11: /device/0/rate_hz: -1 is out of range"),
                                 HasSubstr("r.toml:11:1: /device/0/emulate/colour: unknown key")));
}

}  // namespace problems_test
}  // namespace drydock::rig_config::test
