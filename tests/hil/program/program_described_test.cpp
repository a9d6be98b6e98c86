// Commands that take a protocol take the name of a description, or its path.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "tests/hil/program/program.hpp"

namespace program_described_test {

using program::drydock;
using program::Folder;
using testing::HasSubstr;

constexpr const char* sentences = "fixtures/described/valeport-vat.txt";
constexpr const char* frames = "fixtures/xsens/frames.log";

TEST(Program, MonitorShowsTheMessagesOfADescribedLine) {
  for (const std::string name : {"valeport-vat.toml", "rig_config/devices/valeport-vat.toml"}) {
    const auto shown =
        drydock("monitor 'file:" + std::string(sentences) + "?speed=max' --protocol " + name);
    EXPECT_EQ(shown.exit_code, 0) << shown.output;
    EXPECT_THAT(shown.output, HasSubstr("\"altitude_m\":0.115,\"pressure_pa\":100730"));
    EXPECT_THAT(shown.output, HasSubstr("3 messages"));
  }
}

TEST(Program, MonitorShowsTheMessagesOfADescribedBus) {
  const auto shown =
      drydock("monitor 'file:" + std::string(frames) + "?speed=max' --protocol xsens-dbc.toml");
  EXPECT_EQ(shown.exit_code, 0) << shown.output;
  EXPECT_THAT(shown.output, HasSubstr("\"type\":\"rate_of_turn\""));
}

TEST(Program, DescribePrintsThePageAndTheDbcFileOfADescription) {
  const auto page = drydock("describe --page valeport-vat.toml");
  EXPECT_EQ(page.exit_code, 0) << page.output;
  EXPECT_THAT(page.output, HasSubstr("Begins with `$PRVAT,`."));
  EXPECT_THAT(page.output, HasSubstr("`pressure_pa`"));
  const auto dbc = drydock("describe --dbc xsens-dbc.toml");
  EXPECT_EQ(dbc.exit_code, 0) << dbc.output;
  EXPECT_THAT(dbc.output, HasSubstr("BO_ 50 rate_of_turn: 6 "));
  const Folder folder;
  std::ofstream(folder / "s.dbc") << dbc.output;
  const auto checked = drydock("check " + (folder / "s.dbc").string());
  EXPECT_EQ(checked.exit_code, 0) << checked.output;
  const auto bytes = drydock("describe --dbc valeport-vat.toml");
  EXPECT_EQ(bytes.exit_code, 2);
  EXPECT_THAT(bytes.output, HasSubstr("valeport-vat.toml describes bytes; allowed: a description "
                                      "of CAN frames"));
}

TEST(Program, AMisspelledDescriptionIsToldByEveryCommandThatTakesOne) {
  const std::string file = sentences;
  for (const std::string& command : {"monitor file:" + file, "decode " + file, "replay " + file,
                                     "characterize " + file, std::string("proxy pty:a pty:b")}) {
    const auto run = drydock(command + " --protocol valport-vat.toml");
    EXPECT_EQ(run.exit_code, 2) << command;
    EXPECT_THAT(run.output, HasSubstr("did you mean 'valeport-vat.toml'?")) << command;
  }
}

TEST(Program, ACaptureOfADescribedSensorIsCharacterized) {
  const Folder folder;
  std::ofstream log(folder / "vat.txt");
  for (int i = 0; i < 400; ++i)
    log << (i % 2 == 0 ? "$PRVAT,00.115,M,0010.073,dBar*39\r\n"
                       : "$PRVAT,00.210,M,0007.497,Metres*3a\r\n");
  log.close();
  const auto run = drydock("characterize " + (folder / "vat.txt").string() +
                           " --protocol valeport-vat.toml --baud 19200");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("depth"));
}

TEST(Program, AProxyKnowsTheMessagesOfADescription) {
  const Folder folder;
  const auto with = [&](const std::string& protocol, const std::string& fault) {
    std::ofstream(folder / "f.toml") << "[[fault]]\ndevice = \"a\"\nfault = \"" << fault << "\"\n";
    return drydock("proxy pty:real pty:virtual --device a --for 0.1s --protocol " + protocol +
                   " --faults " + (folder / "f.toml").string());
  };
  EXPECT_EQ(with("valeport-vat.toml", "bad-checksum").exit_code, 0);
  EXPECT_THAT(with("digiquartz.toml", "bad-checksum").output,
              HasSubstr("its protocol has no checksum of its own"));
  EXPECT_THAT(with("xsens-dbc.toml", "drop").output, HasSubstr("not one that travels as bytes"));
}

// Three programs, as in program_proxy_test.cpp: the proxy drops whole sentences of the description.
TEST(Program, AProxyDropsMessagesOfADescribedSensor) {
  const Folder folder;
  std::ofstream(folder / "rig.toml")
      << "[rig]\nname = \"vat\"\n[[device]]\nname = \"vat\"\nkind = \"depth\"\n"
         "protocol = \"valeport-vat.toml\"\nlink = \"pty:real?baud=38400\"\nrate_hz = 20\n";
  std::ofstream(folder / "f.toml")
      << "[[fault]]\ndevice = \"vat\"\nfault = \"drop\"\nprobability = 0.5\n";
  const auto run = drydock(
      "emulate " + (folder / "rig.toml").string() + " > /dev/null & " +
      program::until_linked("real") +
      DRYDOCK_PROGRAM
      " proxy 'pty:real?baud=38400' pty:vat --protocol valeport-vat.toml --device vat --faults " +
      (folder / "f.toml").string() + " --for 3s 2>/dev/null; kill $!; wait");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("drop: "));
}

}  // namespace program_described_test
