// `run` in one process, in real and virtual time, with faults set from another process.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/hil/program/program.hpp"

namespace program_run_test {

using program::drydock;
using program::Folder;
using program::read_file;
using testing::HasSubstr;

TEST(Program, ALockstepRunWritesAReportAndASummary) {
  const Folder folder;
  const auto run = drydock(
      "run rig_config/rigs/demo.toml --for 30s --speed max --expect-streaming "
      "--expect-rms 0.5 --json " +
      (folder / "s.json").string() + " --report " + (folder / "report").string());
  EXPECT_EQ(run.exit_code, 0) << run.output;
  const auto summary = nlohmann::json::parse(read_file(folder / "s.json"));
  EXPECT_EQ(summary["devices"].size(), 6u);
  EXPECT_DOUBLE_EQ(summary["duration_s"], 30.0);
  EXPECT_LT(summary["estimators"][0]["whole_run"]["roll_rms_deg"], 0.5);
  const auto page = read_file(folder / "report/index.html");
  EXPECT_THAT(page, HasSubstr("<figure class=plot"));
  EXPECT_THAT(page, HasSubstr("Roll: truth and estimate"));
  EXPECT_THAT(page, HasSubstr("6 of 6 devices streaming"));
  EXPECT_THAT(page, testing::Not(HasSubstr("src=")));
  EXPECT_THAT(page, testing::Not(HasSubstr("<link")));
}

TEST(Program, AnUnmetExpectationExitsWithOneAndSaysWhich) {
  const auto run =
      drydock("run rig_config/rigs/demo.toml --for 5s --speed max --expect-rms 0.000001");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.output, HasSubstr("expected at most 1e-06"));
}

TEST(Program, ARealTimeRunStreamsFromAllSixDevices) {
  const auto run = drydock("run rig_config/rigs/demo.toml --for 6s --expect-streaming");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_THAT(run.output, HasSubstr("CAN bus can:auto"));
}

TEST(Program, InterruptEndsARunCleanlyWithTheReport) {
  const Folder folder;
  const auto page = folder / "out/index.html";
  const auto outcome =
      drydock("run rig_config/rigs/demo.toml --report " + (folder / "out").string() +
              " > /dev/null & p=$!; sleep 5; kill -INT $p; wait $p");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(read_file(page), HasSubstr("interrupted"));
}

TEST(Program, AFaultIsSetListedAndClearedWhileTheBenchRuns) {
  const Folder folder;
  const std::string rig = "rig_config/rigs/demo.toml",
                    fault = DRYDOCK_PROGRAM " fault " + rig + " ";
  const auto outcome = drydock(
      "run " + rig + " --json " + (folder / "s.json").string() + " > " +
      (folder / "run.txt").string() + " & " + program::until_linked("demo.control") + fault +
      "set dvl garbage bytes=32 --for 1s; " + fault + "set emlog unplug; " + fault + "list; " +
      fault + "set emlog bottom-lost 2>&1; " + fault + "clear emlog; " + "n=0; until " + fault +
      "list | grep -q 'no fault' || [ $((n += 1)) = 100 ]; do sleep .1; done; " + fault +
      "list; kill -INT $!; wait");
  EXPECT_THAT(outcome.output, HasSubstr("set: dvl: garbage, bytes = 32, for 1 s"));
  EXPECT_THAT(outcome.output, HasSubstr("emlog: unplug (since "));
  EXPECT_THAT(outcome.output, HasSubstr("only a dvl hears the sea bed"));
  EXPECT_THAT(outcome.output, HasSubstr("cleared: 1"));
  EXPECT_THAT(outcome.output, HasSubstr("no fault is in force"));
  EXPECT_THAT(read_file(folder / "run.txt"), HasSubstr(" s fault set: emlog: unplug"));
  const auto summary = nlohmann::json::parse(read_file(folder / "s.json"));
  ASSERT_EQ(summary["faults"].size(), 2u) << summary["faults"];
  EXPECT_NEAR(summary["faults"][0]["until_s"].get<double>(),
              summary["faults"][0]["since_s"].get<double>() + 1, 0.001);
}

TEST(Program, AFaultNeedsABenchThatRunsAndSaysHowToStartOne) {
  const auto set = drydock("fault rig_config/rigs/demo.toml set dvl hang");
  EXPECT_EQ(set.exit_code, 1);
  EXPECT_THAT(set.output, HasSubstr("start one: drydock run rig_config/rigs/demo.toml"));
  const auto words = drydock("fault rig_config/rigs/demo.toml words");
  EXPECT_EQ(words.exit_code, 0);
  EXPECT_THAT(words.output, HasSubstr("bottom-lost"));
}

TEST(Program, AFileOfFaultsIsPutOnALockstepRunAndAWrongOneRefused) {
  const Folder folder;
  std::ofstream(folder / "f.toml")
      << "[[fault]]\ndevice = \"emlog\"\nfault = \"hang\"\nstart_s = 5\nfor_s = 10\n";
  const std::string run = "run rig_config/rigs/demo.toml --for 20s --speed max --faults ";
  const auto outcome = drydock(run + (folder / "f.toml").string());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("fault 5.000 s to 15.000 s: emlog: hang"));
  std::ofstream(folder / "bad.toml") << "[[fault]]\ndevice = \"emlog\"\nfault = \"bottom-lost\"\n";
  const auto refused = drydock(run + (folder / "bad.toml").string());
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.output, HasSubstr("bad.toml:1:1: /fault: emlog \"emlog\""));
}

TEST(Program, ARunIsRecordedInFilesThatAreEachComplete) {
  const Folder folder;
  const std::string run = "run rig_config/rigs/demo.toml --for 20s --speed max --record " +
                          (folder / "dive.mcap").string();
  const auto outcome = drydock(run + " --split-every 5s --keep 12s");
  EXPECT_THAT(outcome.output, HasSubstr("dive-0001.mcap and 3 more, the oldest 1 deleted: "));
  EXPECT_FALSE(std::filesystem::exists(folder / "dive-0001.mcap"));
  for (const char* part : {"dive-0002.mcap", "dive-0004.mcap"})
    EXPECT_EQ(drydock("replay --quiet " + (folder / part).string()).exit_code, 0) << part;
  const auto again = drydock(run + " --split-size 1GiB");
  EXPECT_THAT(again.output, HasSubstr("dive-0005.mcap: "));
}

TEST(Program, OptionsOfASplitRecordingThatCannotBeMeantAreRefused) {
  const std::string record = "record rig_config/rigs/demo.toml -o /dev/null ";
  for (const auto& [options, why] : std::vector<std::pair<std::string, std::string>>{
           {"--keep 3h", "--keep: needs --split-size or --split-every"},
           {"--keep 3parsec --split-every 1h", "--keep: '3parsec' is no size"},
           {"--split-every 0", "--split-every: '0' is no duration"},
           {"--split-size 500", "--split-size: '500' is no size"},
           {"--split-size 1GB --overwrite", "excludes"}}) {
    const auto refused = drydock(record + options);
    EXPECT_EQ(refused.exit_code, 2) << options;
    EXPECT_THAT(refused.output, HasSubstr(why));
  }
}

}  // namespace program_run_test
