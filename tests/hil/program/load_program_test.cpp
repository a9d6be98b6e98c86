// `drydock load` in a script: its last line and its exit code agree.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/hil/program/program.hpp"

namespace load_program_test {

using program::drydock;
using program::Folder;
using testing::ContainsRegex;
using testing::HasSubstr;

std::filesystem::path rig_in(const Folder& folder, const std::string& faults) {
  std::ofstream(folder / "rig.toml")
      << "[rig]\nname = \"log\"\npublish = false\n[[device]]\nname = \"log\"\nkind = \"emlog\"\n"
         "protocol = \"nmea0183\"\nlink = \"memory:load?baud=38400\"\nrate_hz = 5\n"
      << faults;
  return folder / "rig.toml";
}

// The test does not require that this machine is on time.
TEST(Load, ItsLastLineItsJsonAndItsExitCodeSayTheSame) {
  const Folder folder;
  const auto json = folder / "load.json";
  const auto load =
      drydock("load " + rig_in(folder, "").string() + " --for 2s --json " + json.string());
  const auto figures = nlohmann::json::parse(program::read_file(json));
  const bool passed = figures["passed"];
  EXPECT_EQ(load.exit_code, passed ? 0 : 1) << load.output;
  EXPECT_THAT(load.output, HasSubstr(passed ? "PASS 1 devices" : "FAIL 1 of 1 devices"));
  EXPECT_THAT(load.output, HasSubstr("this host's timer"));
  const auto& log = figures["devices"][0];
  EXPECT_EQ(log["device"], "log");
  EXPECT_EQ(log["period_ms"], 200);
  EXPECT_GT(log["samples"], 5);
  EXPECT_EQ(log["lost"], 0);
}

TEST(Load, ADeviceThatFallsSilentFails) {
  const Folder folder;
  const auto rig = rig_in(folder, "[[fault]]\ndevice = \"log\"\nfault = \"off\"\nstart_s = 1\n");
  const auto load = drydock("load " + rig.string() + " --for 3s");
  EXPECT_EQ(load.exit_code, 1);
  EXPECT_THAT(load.output, HasSubstr("Hz instead of 5.000"));
  EXPECT_THAT(load.output, HasSubstr("FAIL 1 of 1 devices"));
}

TEST(Load, CtrlCEndsItWithWhatWasRunAndNoPass) {
  const Folder folder;
  const auto rig = rig_in(folder, "");
  const auto load = drydock(
      "check " + rig.string() +
      " >/dev/null; timeout --preserve-status --foreground -s INT 2 " DRYDOCK_PROGRAM " load " +
      rig.string() + " --for 1min; echo exit $?");
  // A busy computer starts the program late, so that less than the two seconds was run.
  EXPECT_THAT(load.output,
              ContainsRegex("FAIL 0 of 1 devices in [12] s, ended by Ctrl-C before 60 s"));
  EXPECT_THAT(load.output, HasSubstr("exit 130"));
}

}  // namespace load_program_test
