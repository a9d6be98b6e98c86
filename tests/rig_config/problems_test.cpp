#include "tests/rig_config/problems.hpp"

#include <rapidcheck/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

/// Rig files: keys, types, ranges, names.
namespace drydock::rig_config::test {
namespace problems_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(RigProblems, TheSmallestRigHasNone) { EXPECT_THAT(problems_of(""), IsEmpty()); }

TEST(RigProblems, AnUnknownKeyIsNamedWithTheAllowedOnesAndTheLikelyOne) {
  EXPECT_THAT(problems_of("colour = 5\n"),
              ElementsAre("r.toml:8:1: /device/0/colour: unknown key, allowed here: emulate, "
                          "kind, latency_ms, lever_arm_m, link, mounting_deg, name, protocol, "
                          "rate_hz, reopen_after_s, stale_after_s"));
  EXPECT_THAT(problems_of("rate_h = 5\n"),
              ElementsAre(HasSubstr("/device/0/rate_h: unknown key (did you mean 'rate_hz'?), ")));
}

TEST(RigProblems, AnUnknownTableIsAnUnknownKey) {
  EXPECT_THAT(problems_of("[[devices]]\n"),
              ElementsAre("r.toml:8:3: /devices: unknown key (did you mean 'device'?), allowed "
                          "here: device, estimator, expect, fault, rig"));
}

TEST(RigProblems, AMissingKeyIsReportedWhereItsTableBegins) {
  EXPECT_THAT(problems_of("[[device]]\nname = \"gnss\"\nkind = \"gnss\"\nprotocol = \"ubx\"\n"),
              ElementsAre("r.toml:8:1: /device/1: key 'link' is missing"));
}

TEST(RigProblems, AWrongChoiceIsToldTheAllowedOnes) {
  EXPECT_THAT(
      problems_of("[[estimator]]\nname = \"l\"\nkind = \"levelling\"\nimu = \"imu\"\n"
                  "model = \"stationary\"\n" +
                  std::string(imu_table)),
      ElementsAre("r.toml:10:8: /estimator/0/kind: \"levelling\" is not allowed (did you "
                  "mean 'leveling'?), allowed: leveling, mixing, roll, navigation, velocity"));
}

TEST(RigProblems, AProtocolMustFitTheKind) {
  EXPECT_THAT(problems_of("[[device]]\nname = \"g\"\nkind = \"gnss\"\nprotocol = \"pd0\"\n"
                          "link = \"pty:g\"\n"),
              ElementsAre("r.toml:11:12: /device/1/protocol: \"pd0\" is not allowed, allowed: ubx, "
                          "nmea0183, ubx+nmea0183"));
}

TEST(RigProblems, AWrongTypeNamesBoth) {
  EXPECT_THAT(problems_of("rate_hz = \"5\"\n"),
              ElementsAre("r.toml:8:11: /device/0/rate_hz: expected a number, found a string"));
  EXPECT_THAT(problems_of("emulate = { velocity_bias_mps = true }\n"),
              ElementsAre("r.toml:8:33: /device/0/emulate/velocity_bias_mps: expected a number or "
                          "an array, found true or false"));
}

TEST(RigProblems, ANumberOutOfRangeIsToldTheRange) {
  EXPECT_THAT(problems_of("rate_hz = 0\n"),
              ElementsAre("r.toml:8:11: /device/0/rate_hz: 0 is out of range, allowed: above 0, up "
                          "to 1000"));
  EXPECT_THAT(
      problems_of("[[device]]\nname = \"d\"\nkind = \"depth\"\nprotocol = \"nmea2000\"\n"
                  "link = \"can:auto\"\naddress = 254\n"),
      ElementsAre("r.toml:13:11: /device/1/address: 254 is out of range, allowed: 0 to 253"));
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

TEST(RigProblems, ADvlDoesNotSpeakOnCan) {
  EXPECT_THAT(
      problems_of("[[device]]\nname = \"d\"\nkind = \"dvl\"\nprotocol = \"pd0\"\n"
                  "link = \"socketcan:can0\"\n"),
      ElementsAre("r.toml:12:8: /device/1/link: \"socketcan:can0\" is not a link for bytes: "
                  "serial: pty: tcp: udp: file: memory:"));
}

TEST(RigProblems, TheCallersLinkCheckSpeaksWithAPosition) {
  const LoadOptions options{[](std::string_view uri) -> std::optional<std::string> {
    if (uri == "pty:dvl") return std::nullopt;
    return std::string(uri) + ": no such name";
  }};
  EXPECT_THAT(problems_of("", options), IsEmpty());
  EXPECT_THAT(problems_of("[[device]]\nname = \"g\"\nkind = \"gnss\"\nprotocol = \"ubx\"\n"
                          "link = \"pty:x/y\"\n",
                          options),
              ElementsAre("r.toml:12:8: /device/1/link: pty:x/y: no such name"));
  EXPECT_THAT(problems_of("[[device]]\nname = \"g\"\nkind = \"gnss\"\nprotocol = \"ubx\"\n"
                          "link = \"ptty:x\"\n",
                          options),
              ElementsAre("r.toml:12:8: /device/1/link: ptty:x: no such name"));
}

TEST(RigProblems, ANameIsUsedOnce) {
  EXPECT_THAT(
      problems_of(dvl_table),
      ElementsAre("r.toml:9:8: /device/1/name: \"dvl\" is used twice, first in line 4; each "
                  "device needs its own"));
  EXPECT_THAT(
      problems_of("[[device]]\nname = \"the dvl\"\nkind = \"dvl\"\nprotocol = \"pd0\"\n"
                  "link = \"pty:b\"\n"),
      ElementsAre("r.toml:9:8: /device/1/name: \"the dvl\" is not a name: letters, digits, _ "
                  "and -, a letter first"));
}

TEST(RigProblems, AnEstimatorsDevicesExistAndAreOfTheRightKind) {
  const std::string more = std::string(imu_table) +
                           "[[estimator]]\nname = \"l\"\nkind = \"leveling\"\nimu = \"imx\"\n"
                           "log = \"dvl\"\n";
  EXPECT_THAT(problems_of(more),
              ElementsAre("r.toml:16:7: /estimator/0/imu: no device is named \"imx\" (did you mean "
                          "'imu'?), allowed: imu",
                          "r.toml:17:7: /estimator/0/log: device \"dvl\" is of kind dvl, this rig "
                          "has no device of kind emlog"));
}

TEST(RigProblems, KeysThatDependOnAChoiceSaySo) {
  const std::string head =
      std::string(imu_table) + "[[estimator]]\nname = \"l\"\nkind = \"leveling\"\nimu = \"imu\"\n";
  EXPECT_THAT(problems_of(head), ElementsAre("r.toml:13:1: /estimator/0: key 'log' is missing"));
  EXPECT_THAT(problems_of(head + "model = \"stationary\"\ninitial_roll_deg = 1\n"),
              ElementsAre("r.toml:18:1: /estimator/0/initial_roll_deg: not allowed here, only with "
                          "start = \"given\""));
  EXPECT_THAT(problems_of(head + "model = \"stationary\"\nstart = \"given\"\n"
                                 "initial_roll_deg = 1\n"),
              ElementsAre("r.toml:13:1: /estimator/0: key 'initial_pitch_deg' is missing"));
}

TEST(RigProblems, KeysOfOneKindOfEstimatorAreNotThoseOfAnother) {
  const auto head = [](const std::string& kind) {
    return std::string(imu_table) + "[[estimator]]\nname = \"l\"\nkind = \"" + kind +
           "\"\nimu = \"imu\"\n";
  };
  EXPECT_THAT(problems_of(head("leveling") + "model = \"stationary\"\ntype = \"type2\"\n"),
              ElementsAre("r.toml:18:1: /estimator/0/type: not allowed here, only for kind = "
                          "\"mixing\""));
  EXPECT_THAT(problems_of(head("mixing") + "filter = \"robust\"\n"),
              testing::UnorderedElementsAre(
                  "r.toml:13:1: /estimator/0: key 'log' is missing",
                  "r.toml:17:1: /estimator/0/filter: not allowed here, only for kind = "
                  "\"leveling\""));
}

TEST(RigProblems, ThePapersFilterStartsFromAGivenAttitudeAlone) {
  const std::string head = std::string(imu_table) +
                           "[[estimator]]\nname = \"l\"\nkind = \"leveling\"\nimu = \"imu\"\n"
                           "model = \"stationary\"\n";
  EXPECT_THAT(problems_of(head + "filter = \"paper\"\n"),
              ElementsAre("r.toml:13:1: /estimator/0: key 'start' is missing"));
  EXPECT_THAT(problems_of(head + "filter = \"paper\"\nstart = \"accelerometer\"\n"),
              ElementsAre("r.toml:19:9: /estimator/0/start: \"accelerometer\" is not allowed, "
                          "allowed: given"));
  EXPECT_THAT(problems_of(head + "filter = \"augmentd\"\n"),
              ElementsAre("r.toml:18:10: /estimator/0/filter: \"augmentd\" is not allowed (did you "
                          "mean 'augmented'?), allowed: robust, augmented, paper"));
}

TEST(RigProblems, ARollEstimatorNeedsAReceiverAndHasNoLog) {
  const std::string head =
      std::string(imu_table) + "[[estimator]]\nname = \"r\"\nkind = \"roll\"\nimu = \"imu\"\n";
  EXPECT_THAT(problems_of(head), ElementsAre("r.toml:13:1: /estimator/0: key 'gnss' is missing"));
  EXPECT_THAT(problems_of(head + "gnss = \"imu\"\n"),
              ElementsAre("r.toml:17:8: /estimator/0/gnss: device \"imu\" is of kind imu, this rig "
                          "has no device of kind gnss"));
}

TEST(RigProblems, AnInertialNavigationNeedsAStartAndItsSensorsGrades) {
  const std::string head = std::string(imu_table) +
                           "[[estimator]]\nname = \"n\"\nkind = \"navigation\"\nimu = \"imu\"\n";
  EXPECT_THAT(problems_of(head),
              ElementsAre("r.toml:13:1: /estimator/0: key 'sensors' is missing",
                          "r.toml:13:1: /estimator/0: key 'initial' is missing"));
}

TEST(RigProblems, AnAddressIsTakenOncePerBus) {
  const std::string depth =
      "[[device]]\nname = \"d1\"\nkind = \"depth\"\nprotocol = \"nmea2000\"\nlink = \"can:auto\"\n"
      "address = 35\n";
  const std::string actuators =
      "[[device]]\nname = \"a1\"\nkind = \"actuator\"\nprotocol = \"nmea2000\"\n"
      "link = \"can:auto\"\naddress = 35\n";
  EXPECT_THAT(problems_of(depth + actuators),
              ElementsAre("r.toml:19:11: /device/2/address: 35 is already the address of 'd1' on "
                          "can:auto; each device on a bus needs its own"));
}

TEST(RigProblems, StartIsADateTimeWithAnOffset) {
  const std::string device(dvl_table);
  EXPECT_THAT(problems_of_text("[rig]\nname = \"r\"\nstart = \"2026-11-21T08:00:00Z\"\n" + device),
              ElementsAre("r.toml:3:9: /rig/start: expected a date-time without quotes such as "
                          "2026-11-21T08:00:00Z, found a string"));
  EXPECT_THAT(problems_of_text("[rig]\nname = \"r\"\nstart = 2026-11-21T08:00:00\n" + device),
              ElementsAre("r.toml:3:9: /rig/start: this date-time has no offset, write for example "
                          "2026-11-21T08:00:00Z"));
  EXPECT_THAT(problems_of_text("[rig]\nname = \"r\"\nmission = 2026-11-21T08:00:00Z\n" + device),
              ElementsAre("r.toml:3:11: /rig/mission: expected a string, found a date-time"));
}

TEST(RigProblems, AChoiceIsAString) {
  EXPECT_THAT(problems_of_text("[rig]\nname = \"r\"\n[[device]]\nname = \"d\"\nprotocol = \"pd0\"\n"
                               "link = \"pty:d\"\nkind = 2026-11-21T08:00:00Z\n"),
              ElementsAre("r.toml:7:8: /device/0/kind: expected one of: dvl, emlog, gnss, imu, "
                          "depth, actuator, found a date-time"));
}

TEST(RigProblems, SyntaxErrorsHaveTheSameForm) {
  EXPECT_THAT(problems_of_text("[rig]\nname = bench\n"), ElementsAre(HasSubstr("r.toml:2:")));
  EXPECT_THAT(problems_of_text("[rig]\nname = \"a\"\nname = \"b\"\n"),
              ElementsAre(HasSubstr("r.toml:3:")));
}

TEST(RigProblems, ARigNeedsADevice) {
  EXPECT_THAT(problems_of_text("[rig]\nname = \"r\"\n"),
              ElementsAre("r.toml:1:1: /: key 'device' is missing"));
  EXPECT_THAT(problems_of_text("device = []\n[rig]\nname = \"r\"\n"),
              ElementsAre("r.toml:1:10: /device: has 0 values, allowed: 1 to 256"));
}

TEST(RigProblems, AnotherKindOfFileIsNoRig) {
  EXPECT_THAT(problems_of_text("[mission]\n"),
              ElementsAre("r.toml:1:1: /: expected a rig file, which has a table [rig]"));
}

TEST(RigProblems, FilesThatAreNotThereAreProblemsOfTheLineThatNamesThem) {
  const std::string text = "[rig]\nname = \"r\"\nmission = \"m/none.toml\"\n" +
                           std::string(dvl_table) + "emulate = { errors = \"none.toml\" }\n";
  const auto rig = load_rig_text(text, "/rigs/r.toml");
  ASSERT_FALSE(rig);
  EXPECT_THAT(lines_of(rig.error()),
              ElementsAre("/rigs/r.toml:3:11: /rig/mission: there is no file /rigs/m/none.toml",
                          "/rigs/r.toml:9:22: /device/0/emulate/errors: there is no file "
                          "/rigs/none.toml"));
}

TEST(RigProblems, ARigFileThatCannotBeReadIsOneLine) {
  const auto rig = load_rig("/nowhere/r.toml");
  ASSERT_FALSE(rig);
  EXPECT_THAT(lines_of(rig.error()), ElementsAre("/nowhere/r.toml:0:0: /: cannot be read: it is "
                                                 "missing, empty or not a file"));
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

RC_GTEST_PROP(RigProblems, NoTextMakesTheLoaderThrow, (const std::string& text)) {
  const auto rig = load_rig_text(text, "r.toml");
  RC_ASSERT(!rig);
  RC_ASSERT(!rig.error().empty());
}

/// The demo with one line gone, or with one line's value exchanged: sound, or told why not.
TEST(RigProblems, AListOrATableWhereADateTimeBelongsIsToldAndDoesNotAbort) {
  for (const std::string value : {"[]", "[[1]]", "{}", "{ a = 1 }"}) {
    const auto rig = load_rig_text("[rig]\nname = \"x\"\nstart = " + value + "\n", "r.toml");
    ASSERT_FALSE(rig) << value;
    EXPECT_TRUE(std::ranges::any_of(rig.error(), [](const Problem& problem) {
      return problem.path.starts_with("/rig/start");
    })) << value;
  }
}

RC_GTEST_PROP(RigProblems, ADamagedDemoIsLoadedOrToldWhyNot, ()) {
  const std::string path = DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml";
  std::vector<std::string> lines;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  const auto victim = *rc::gen::inRange<std::size_t>(0, lines.size());
  const auto value = *rc::gen::element<std::string>("", "1", "-1e300", "\"\"", "[]", "{}", "true",
                                                    "[[1]]", "1979-05-27", "\"\\u0000\"");
  const auto equals = lines[victim].find('=');
  lines[victim] = value.empty() || equals == std::string::npos
                      ? ""
                      : lines[victim].substr(0, equals + 1) + value;
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  const auto rig = load_rig_text(text, path);
  if (rig) return;
  for (const Problem& problem : rig.error()) RC_ASSERT(problem.line > 0 && !problem.what.empty());
}

}  // namespace problems_test
}  // namespace drydock::rig_config::test
