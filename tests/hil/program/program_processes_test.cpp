// Several processes on one bench: emulate, drive, estimate, monitor.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/hil/program/program.hpp"

namespace program_processes_test {

using program::drydock;
using program::emulated_demo;
using program::Folder;
using program::read_file;
using testing::HasSubstr;

TEST(Program, DriveAndEstimateAsTwoProcessesDoWhatRunDoesInOne) {
  const Folder folder;
  const std::string rig = "rig_config/rigs/demo.toml";
  const std::string log = (folder / "estimates.jsonl").string();
  const auto outcome =
      drydock(emulated_demo + "drive " + rig + " --for 7s > " + (folder / "drive.txt").string() +
              " & drive=$!; " DRYDOCK_PROGRAM " estimate " + rig + " --for 6s --json > " + log +
              "; r=$?; wait $drive; exit $r");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output << read_file(folder / "drive.txt");
  const auto text = read_file(log);
  // 100 Hz for the seconds in which all three run, minus discovery and the filter's start.
  EXPECT_GT(std::count(text.begin(), text.end(), '\n'), 200) << read_file(folder / "drive.txt");
}

// Each process in turn is killed with SIGKILL and started again. The second `drive` finds the ptys
// and buses as the first one left them.
TEST(Program, EitherProcessKilledAndStartedAgainStreamsFromAllDevices) {
  const Folder folder;
  const std::string rig = "rig_config/rigs/demo.toml";
  const auto in_background = [&](const std::string& what, const std::string& name) {
    return DRYDOCK_PROGRAM " " + what + " " + rig + " > " + (folder / name).string() + " 2>&1 & ";
  };
  const auto outcome = drydock(
      "--version; " + in_background("emulate", "emulate1.txt") + "emulate=$!; sleep 1; " +
      in_background("drive", "drive1.txt") + "drive=$!; sleep 3; kill -KILL $drive; " +
      in_background("drive", "drive2.txt") + "drive=$!; sleep 4; kill -KILL $emulate; sleep 1; " +
      in_background("emulate", "emulate2.txt") +
      "emulate=$!; sleep 6; kill -TERM $drive; wait $drive; "
      "echo drive ended with $?; kill -TERM $emulate; wait");
  const auto drive = read_file(folder / "drive2.txt");
  EXPECT_THAT(outcome.output, HasSubstr("drive ended with 0")) << drive;
  for (const char* device : {"imu", "dvl", "emlog", "gnss", "depth", "actuators"}) {
    const auto first = drive.find(std::string(device) + ": waiting -> streaming");
    EXPECT_NE(first, std::string::npos) << device << "\n" << drive;
  }
  EXPECT_THAT(drive, HasSubstr("-> backing off"));
}

TEST(Program, AMonitorOnlyListensSoANodeThatNobodyStartsStaysSilent) {
  const auto outcome = drydock(emulated_demo + "monitor rig_config/rigs/demo.toml --once --for 4s");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("imu        waiting"));
  EXPECT_THAT(outcome.output, HasSubstr("dvl        streaming"));
  EXPECT_THAT(outcome.output, HasSubstr("m/s"));
  EXPECT_THAT(outcome.output, HasSubstr("latency"));
  EXPECT_THAT(outcome.output, HasSubstr("load"));
  const auto quiet = drydock("monitor rig_config/rigs/demo.toml --once --json --for 1s");
  EXPECT_EQ(quiet.exit_code, 1);
  EXPECT_THAT(quiet.output, HasSubstr("\"state\":\"backing off\""));
}

TEST(Program, AMonitorReadsTheBusWhileAnotherProcessHasThePorts) {
  const auto outcome = drydock(emulated_demo +
                               "drive rig_config/rigs/demo.toml --for 9s > /dev/null & "
                               "drive=$!; sleep 2; " DRYDOCK_PROGRAM
                               " monitor rig_config/rigs/demo.toml --bus --once --json --for 6s; "
                               "r=$?; wait $drive; exit $r");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 6);
  EXPECT_THAT(outcome.output, HasSubstr("\"name\":\"velocity\""));
}

// The frame CFG-RATE, 500 ms, is that of u-blox's documents.
TEST(Program, AMonitorSaysWhatAnEmulatedReceiverWasTold) {
  const std::string told = "was told: CFG-RATE: an epoch each 500 ms";
  const std::string set_rate =
      "printf '\\265\\142\\006\\010\\006\\000\\364\\001\\001\\000\\001\\000\\013\\167' > "
      "$(ls $XDG_RUNTIME_DIR/drydock-*/gnss); ";
  std::string emulated = emulated_demo;
  emulated.insert(emulated.size() - std::string(DRYDOCK_PROGRAM " ").size(), set_rate);
  const std::string rig = "rig_config/rigs/demo.toml --once --for 4s";
  EXPECT_THAT(drydock(emulated + "monitor --bus " + rig).output, HasSubstr(told));
  EXPECT_THAT(drydock(emulated + "monitor " + rig).output, HasSubstr(told));
}

}  // namespace program_processes_test
