#include "rig_config/fault.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "rig_config/fault_vocabulary.hpp"
#include "tests/rig_config/problems.hpp"

/// Blocks [[fault]]: words, keys, amounts, and faults that a device cannot have.
namespace drydock::rig_config::test {
namespace fault_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<FaultConfig> faults_of(const std::string& more) {
  const auto text = std::string(rig_table) + std::string(dvl_table) + more;
  return load_rig_text(text, "r.toml").value().faults;
}

std::vector<std::string> problems_of_dvl(const std::string& lines) {
  return problems_of("[[fault]]\ndevice = \"dvl\"\n" + lines);
}

TEST(Fault, HasAStartAnEndATurnAndASeed) {
  const auto faults = faults_of(
      "[[fault]]\ndevice = \"dvl\"\nfault = \"delay\"\nseconds = 0.25\nstart_s = 30\nfor_s = 5\n"
      "every_s = 60\nseed = 7\n");
  ASSERT_EQ(faults.size(), 1u);
  const FaultConfig& f = faults[0];
  EXPECT_EQ(f.device, "dvl");
  EXPECT_EQ(f.kind, FaultKind::delay);
  EXPECT_EQ(f.amount[0], 0.25);
  EXPECT_EQ(f.start_s, 30);
  EXPECT_EQ(f.for_s, 5);
  EXPECT_EQ(f.every_s, 60);
  EXPECT_EQ(f.seed, 7u);
  EXPECT_EQ(f.words, "dvl: delay, seconds = 0.25");
}

TEST(Fault, WithoutAnEndItHoldsUntilTheRunEnds) {
  const auto faults = faults_of("[[fault]]\ndevice = \"dvl\"\nfault = \"hang\"\n");
  EXPECT_EQ(faults.at(0).start_s, 0);
  EXPECT_EQ(faults.at(0).for_s, std::nullopt);
}

TEST(Fault, TheKeyOfAnAmountSaysQuantityAndUnit) {
  const auto rig =
      load_rig_text(std::string(rig_table) + std::string(imu_table) +
                        "[[fault]]\ndevice = \"imu\"\nfault = \"bias\"\nrate_degps = [0, 0, 90]\n"
                        "[[fault]]\ndevice = \"imu\"\nfault = \"bias\"\nspecific_force_mps2 = 2\n",
                    "r.toml");
  ASSERT_TRUE(rig);
  EXPECT_NEAR(rig->faults[0].amount[2], std::numbers::pi / 2, 1e-15);
  EXPECT_EQ(rig->faults[0].quantity, "rate_degps");
  EXPECT_EQ(rig->faults[1].amount, (std::array<double, 3>{2, 0, 0})) << "one number: one axis";
}

TEST(Fault, AMissionAndAFileOfTheirOwnHaveFaultsToo) {
  const auto file = load_faults_text("[[fault]]\ndevice = \"x\"\nfault = \"off\"\n", "f.toml");
  ASSERT_TRUE(file);
  EXPECT_EQ(file->at(0).file, "f.toml");
  const auto mission = load_mission_text(
      "[mission]\nlatitude_deg = 1\nlongitude_deg = 2\nspeed_mps = 1\n"
      "[[leg]]\nkind = \"straight\"\nduration_s = 60\n"
      "[[fault]]\ndevice = \"dvl\"\nfault = \"bottom-lost\"\nstart_s = 10\n",
      "m.toml");
  ASSERT_TRUE(mission);
  EXPECT_EQ(mission->faults.at(0).kind, FaultKind::bottom_lost);
}

TEST(Fault, AnUnknownWordOrDeviceIsToldTheKnownOnes) {
  EXPECT_THAT(problems_of_dvl("fault = \"hange\"\n"),
              ElementsAre(HasSubstr("r.toml:10:9: /fault/0/fault: \"hange\" is not allowed "
                                    "(did you mean 'hang'?), allowed: off, stuck, bias")));
  EXPECT_THAT(problems_of("[[fault]]\ndevice = \"dvll\"\nfault = \"hang\"\n"),
              ElementsAre("r.toml:8:1: /fault: no device is named \"dvll\" (did you mean 'dvl'?), "
                          "allowed: dvl"));
}

TEST(Fault, AnotherWordOfTheTradeIsTakenForTheKnownOne) {
  for (const auto& [typed, meant] :
       {std::pair{"freeze", "stuck"}, {"outlier", "spike"}, {"stop", "hang"}, {"Offset", "bias"}})
    EXPECT_THAT(problems_of_dvl(std::string("fault = \"") + typed + "\"\n"),
                ElementsAre(HasSubstr(std::string("(did you mean '") + meant + "'?)")));
  EXPECT_THAT(problems_of("[[fault]]\ndevice = \"doppler\"\nfault = \"hang\"\n"),
              ElementsAre(HasSubstr("\"doppler\" (did you mean 'dvl'?)")));
  EXPECT_THAT(problems_of("[[fault]]\ndevice = \"gps\"\nfault = \"hang\"\n"),
              ElementsAre(testing::Not(HasSubstr("did you mean"))));  // the rig has none
}

TEST(Fault, AKeyThatTheFaultDoesNotHaveIsRefused) {
  EXPECT_THAT(problems_of_dvl("fault = \"hang\"\nseconds = 3\n"),
              ElementsAre(HasSubstr("/fault/0/seconds: the fault \"hang\" has no seconds, allowed: "
                                    "start_s, for_s, every_s")));
  EXPECT_THAT(problems_of_dvl("fault = \"delay\"\nprobability = 0.5\n"),
              ElementsAre(HasSubstr("has no probability, allowed: seconds")));
}

TEST(Fault, AnAmountThatMustBeGivenOrIsOutOfRangeIsToldSo) {
  EXPECT_THAT(problems_of_dvl("fault = \"wrong-baud\"\n"),
              ElementsAre(HasSubstr("/fault/0: the fault \"wrong-baud\" needs baud")));
  EXPECT_THAT(problems_of_dvl("fault = \"bias\"\n"),
              ElementsAre(HasSubstr("the fault \"bias\" needs one of: velocity_mps, speed_mps")));
  EXPECT_THAT(problems_of_dvl("fault = \"drop\"\nprobability = 1.5\n"), testing::Not(IsEmpty()));
  EXPECT_THAT(problems_of_dvl("fault = \"slow\"\ntimes = 0.5\n"),
              ElementsAre(HasSubstr("/fault/0/times: 0.5 is out of range, allowed: 1 to 1000")));
}

TEST(Fault, OneThatComesAgainEndsBeforeItBegins) {
  EXPECT_THAT(problems_of_dvl("fault = \"hang\"\nevery_s = 10\n"),
              ElementsAre(HasSubstr("/fault/0/every_s: a fault that comes again needs for_s")));
  EXPECT_THAT(problems_of_dvl("fault = \"hang\"\nevery_s = 10\nfor_s = 10\n"),
              ElementsAre(HasSubstr("/fault/0/every_s: must be above for_s, which is 10")));
}

TEST(Fault, WhatADeviceCannotHaveIsRefusedWithTheReason) {
  EXPECT_THAT(problems_of_dvl("fault = \"satellites-blocked\"\n"),
              ElementsAre("r.toml:8:1: /fault: dvl \"dvl\" (pd0) cannot have the fault "
                          "\"satellites-blocked\": only a gnss receiver has satellites"));
  EXPECT_THAT(problems_of_dvl("fault = \"bus-off\"\n"), ElementsAre(HasSubstr("only a CAN bus")));
  EXPECT_THAT(problems_of_dvl("fault = \"noise\"\n"), ElementsAre(HasSubstr("without noise")));
  const auto of_imu = [](const std::string& fault) {
    return problems_of_text(std::string(rig_table) + std::string(imu_table) +
                            "[[fault]]\ndevice = \"imu\"\nfault = \"" + fault + "\"\n");
  };
  EXPECT_THAT(of_imu("unplug"), ElementsAre(HasSubstr("a node on a bus is not a port")));
  EXPECT_THAT(of_imu("bad-checksum"), ElementsAre(HasSubstr("no checksum of its own")));
  EXPECT_THAT(of_imu("address-stolen"), ElementsAre(HasSubstr("only J1939 and NMEA 2000")));
  EXPECT_THAT(of_imu("bottom-lost"), ElementsAre(HasSubstr("only a dvl hears the sea bed")));
}

/// Without this check a quantity that the device does not measure would be accepted and do nothing.
TEST(Fault, AQuantityOfAnotherKindOfSensorIsRefused) {
  EXPECT_THAT(problems_of_dvl("fault = \"bias\"\nrate_degps = 1\n"),
              ElementsAre(HasSubstr("a dvl measures velocity_mps, not rate_degps")));
}

TEST(Fault, BehindARecordingOrAProxyOnlyTheWireCanHaveFaults) {
  Rig rig = load_rig_text(std::string(rig_table) + std::string(dvl_table), "r.toml").value();
  const auto refused = [&](FaultKind kind, FaultTarget target) {
    FaultConfig fault;
    fault.device = "dvl";
    fault.kind = kind;
    return refusal(fault, rig.devices[0], target).value_or("");
  };
  for (const auto target : {FaultTarget::replayed, FaultTarget::proxied}) {
    for (const auto& word : fault_vocabulary()) {
      const bool of_the_sensor =
          word.layer == FaultLayer::measurement || word.layer == FaultLayer::environment;
      if (of_the_sensor) {
        EXPECT_NE(refused(word.kind, target), "") << word.name;
      } else if (word.layer == FaultLayer::message) {
        EXPECT_EQ(refused(word.kind, target), "") << word.name;
      }
    }
  }
  EXPECT_THAT(refused(FaultKind::stuck, FaultTarget::proxied), HasSubstr("is a real device"));
  EXPECT_THAT(refused(FaultKind::stuck, FaultTarget::replayed), HasSubstr("is a recording"));
}

TEST(Fault, SchemaAndPageNameEveryWordInTheVocabulary) {
  const auto schema = nlohmann::json::parse(schema_text());
  const auto& names = schema["definitions"]["fault"]["properties"]["fault"]["enum"];
  std::ifstream in(DRYDOCK_SOURCE_DIR "/docs/use/faults.md");
  std::ostringstream page;
  page << in.rdbuf();
  ASSERT_EQ(names.size(), fault_vocabulary().size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const FaultWord& word = fault_vocabulary()[i];
    EXPECT_EQ(names[i], word.name);
    EXPECT_EQ(static_cast<std::size_t>(word.kind), i);
    EXPECT_EQ(find_fault(word.name), &word);
    EXPECT_THAT(page.str(), HasSubstr("| `" + std::string(word.name) + "` |"));
  }
}

}  // namespace fault_test
}  // namespace drydock::rig_config::test
