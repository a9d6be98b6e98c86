// A run that did not reach its --for is no pass, and everything that it writes says so.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/hil/program/running.hpp"

namespace short_run_test {

using program::drydock;
using program::Folder;
using program::read_file;
using program::Running;
using testing::HasSubstr;

const std::string demo = "run rig_config/rigs/demo.toml ";

/// Begins a run with a JUnit file, waits until it is at work, and sends the signal.
int ended_by(int signal, const Folder& folder, const std::string& options) {
  Running run(folder, demo + options + " --junit " + (folder / "junit.xml").string(), "out.txt");
  EXPECT_TRUE(run.says("streaming"));
  return run.end(signal);
}

TEST(ShortRun, ATermSignalIsAFailureInTheJUnitFileInRealTime) {
  const Folder folder;
  EXPECT_EQ(ended_by(SIGTERM, folder, "--for 1h"), 130);
  const auto junit = read_file(folder / "junit.xml");
  EXPECT_THAT(junit, HasSubstr("name=\"duration_s: 3600\""));
  EXPECT_THAT(junit, HasSubstr(", then a signal ended the run, expected 3600\""));
  EXPECT_THAT(read_file(folder / "out.txt"), HasSubstr("FAIL rig duration_s: "));
}

TEST(ShortRun, ATermSignalIsAFailureInTheJUnitFileInVirtualTime) {
  const Folder folder;
  EXPECT_EQ(ended_by(SIGTERM, folder, "--for 100h --speed max"), 130);
  EXPECT_THAT(read_file(folder / "junit.xml"), HasSubstr("name=\"duration_s: 360000\""));
}

TEST(ShortRun, ARunWithoutAnEndIsEndedByASignalAndPasses) {
  const Folder folder;
  std::ofstream(folder / "rig.toml")
      << "[rig]\nname = \"log\"\n[[device]]\nname = \"log\"\nkind = \"emlog\"\n"
         "protocol = \"nmea0183\"\nlink = \"pty:log?baud=4800\"\nrate_hz = 2\n";
  Running run(folder, "run " + (folder / "rig.toml").string(), "out.txt");
  ASSERT_TRUE(run.says("streaming"));
  EXPECT_EQ(run.end(SIGTERM), 0) << run.output();
  EXPECT_THAT(run.output(), testing::Not(HasSubstr("duration_s")));
}

TEST(ShortRun, ARunThatReachedItsTimeHasNoSuchLine) {
  const auto run = drydock(demo + "--for 5s --speed max");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.output, testing::Not(HasSubstr("duration_s")));
}

TEST(ShortRun, AFileThatCannotBeWrittenIsNamedAndTheOthersAreWritten) {
  const Folder folder;
  const auto run = drydock(demo + "--for 5s --speed max --json /dev/full --junit " +
                           (folder / "junit.xml").string());
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.output, HasSubstr("cannot write /dev/full: No space left on device"));
  EXPECT_THAT(read_file(folder / "junit.xml"), HasSubstr("</testsuites>"));
}

TEST(ShortRun, ARecordingThatFailedIsNoPass) {
  const auto run = drydock(demo + "--for 5s --speed max --overwrite --record /dev/full");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.output, HasSubstr("FAIL rig recording: "));
  EXPECT_THAT(run.output, HasSubstr("No space left on device"));
}

}  // namespace short_run_test
