#include "rig_config/estimator_name.hpp"
#include "tests/rig_config/problems.hpp"

/// Names in rig files: devices, links, addresses.
namespace drydock::rig_config::test {
namespace names_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(RigNames, ADvlDoesNotSpeakOnCan) {
  EXPECT_THAT(
      problems_of("[[device]]\nname = \"d\"\nkind = \"dvl\"\nprotocol = \"pd0\"\n"
                  "link = \"socketcan:can0\"\n"),
      ElementsAre("r.toml:12:8: /device/1/link: \"socketcan:can0\" is not a link for bytes: "
                  "serial: pty: tcp: udp: file: memory:"));
}

TEST(RigNames, TheCallersLinkCheckSpeaksWithAPosition) {
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

TEST(RigNames, ANameIsUsedOnce) {
  EXPECT_THAT(
      problems_of(dvl_table),
      ElementsAre("r.toml:9:8: /device/1/name: \"dvl\" is used twice, first in line 4; each "
                  "device needs its own"));
}

/// Topics and recordings tell the true motion under this name.
TEST(RigNames, NoEstimatorIsTheTruth) {
  EXPECT_THAT(
      problems_of(std::string(imu_table) + "[[estimator]]\nname = \"truth\"\nkind = \"leveling\"\n"
                                           "imu = \"imu\"\nmodel = \"stationary\"\n"),
      ElementsAre(HasSubstr("/estimator/0/name: \"truth\" is the name of the true motion")));
}

TEST(RigNames, AFunctionThatIsAnEstimatorHasTheSameRule) {
  for (const std::string name :
       {"mine", "M1_", "truth", "", "2m", "_m", "mi ne/../x", "m-1", "ä"}) {
    const auto problems =
        problems_of(std::string(imu_table) + "[[estimator]]\nname = \"" + name +
                    "\"\nkind = \"leveling\"\nimu = \"imu\"\nmodel = \"stationary\"\n");
    EXPECT_EQ(problems.empty(), may_be_estimator(name)) << name;
  }
}

// DDS refuses a topic with any other character. ROS 2 refuses a topic that begins with a digit.
TEST(RigNames, ANameIsOneThatATopicCanHave) {
  const auto named = [](const std::string& name) {
    return problems_of("[[device]]\nname = \"" + name +
                       "\"\nkind = \"dvl\"\nprotocol = \"pd0\"\nlink = \"pty:b\"\n");
  };
  for (const std::string name : {"the dvl", "dvl-2", "2dvl", "_dvl", "dvl/2", "dvl~", "dvl.a"})
    EXPECT_THAT(named(name), ElementsAre("r.toml:9:8: /device/1/name: \"" + name +
                                         "\" is not a name for ROS 2 topics: letters, digits and "
                                         "_, a letter first"));
  EXPECT_THAT(named("Dvl_2"), IsEmpty());
  EXPECT_THAT(problems_of(std::string(imu_table) +
                          "[[estimator]]\nname = \"roll-pitch\"\nkind = \"leveling\"\n"
                          "imu = \"imu\"\nmodel = \"stationary\"\n"),
              ElementsAre(HasSubstr("/estimator/0/name: \"roll-pitch\" is not a name for ROS 2 ")));
  EXPECT_THAT(problems_of_text("[rig]\nname = \"bench-2\"\n" + std::string(dvl_table)), IsEmpty())
      << "a rig's own name is in no topic";
}

TEST(RigNames, AnAddressIsTakenOncePerKindOnABus) {
  const auto node = [](const std::string& name, const std::string& kind) {
    return "[[device]]\nname = \"" + name + "\"\nkind = \"" + kind +
           "\"\nprotocol = \"nmea2000\"\nlink = \"socketcan:can0\"\naddress = 52\n";
  };
  EXPECT_THAT(problems_of(node("g1", "gnss") + node("g2", "gnss")),
              ElementsAre("r.toml:19:11: /device/2/address: 52 is already the address of 'g1' on "
                          "socketcan:can0; each gnss on a bus needs its own"));
  EXPECT_THAT(problems_of(node("g1", "gnss") + node("compass", "attitude")), IsEmpty())
      << "a satellite compass is one node";
}

TEST(RigNames, FilesThatAreNotThereAreProblemsOfTheLineThatNamesThem) {
  const std::string text = "[rig]\nname = \"r\"\nmission = \"m/none.toml\"\n" +
                           std::string(dvl_table) + "emulate = { errors = \"none.toml\" }\n";
  const auto rig = load_rig_text(text, "/rigs/r.toml");
  ASSERT_FALSE(rig);
  EXPECT_THAT(lines_of(rig.error()),
              ElementsAre("/rigs/r.toml:3:11: /rig/mission: there is no file /rigs/m/none.toml",
                          "/rigs/r.toml:9:22: /device/0/emulate/errors: there is no file "
                          "/rigs/none.toml"));
}

}  // namespace names_test
}  // namespace drydock::rig_config::test
