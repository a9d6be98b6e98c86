#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "tests/hil/campaign/made_campaign.hpp"

/// A campaign that failed, ended or lost its disk goes on: nothing is lost and nothing counts
/// twice.
namespace campaign_resume_test {
namespace {

using namespace made_campaign;
using program::drydock;
using program::Folder;
using program::read_file;
using testing::HasSubstr;

TEST(CampaignProgram, AFailedRunIsNamedAndResumeRunsItAgainAlone) {
  const Folder folder;
  const std::string log = (folder / "log").string(), switched = (folder / "switch").string();
  write(folder / "c.toml",
        campaign_text("echo {index} >> " + log + "\nif [ {index} = 3 ] && ! [ -e " + switched +
                          " ]; then echo broken >&2; exit 5; fi\necho '{\"y\": {index}}'",
                      6));
  const std::string command = campaign_in(folder);
  const auto first = drydock(command);
  EXPECT_EQ(first.exit_code, 1);
  EXPECT_THAT(first.output, HasSubstr("exit code 5: broken"));
  EXPECT_THAT(first.output, HasSubstr("1 of 6 runs failed, 0 are missing"));
  EXPECT_EQ(drydock(command).exit_code, 2);  // there are results, and no --resume
  EXPECT_EQ(lines_in(log), 6u);
  write(switched, "");
  const auto second = drydock(command + " --resume");
  EXPECT_EQ(second.exit_code, 0) << second.output;
  EXPECT_THAT(second.output, HasSubstr(": 6 of 6 runs, 5 of them from before, seed "));
  EXPECT_EQ(lines_in(log), 7u);
  EXPECT_THAT(column(folder / "out" / "results.sqlite", "SELECT y FROM runs ORDER BY \"index\""),
              testing::ElementsAre("0.0", "1.0", "2.0", "3.0", "4.0", "5.0"));
}

TEST(CampaignProgram, AChangedFileDoesNotContinueAnotherCampaign) {
  const Folder folder;
  const std::string command = campaign_in(folder);
  write(folder / "c.toml", campaign_text("echo '{\"y\": 1}'", 2));
  EXPECT_EQ(drydock(command).exit_code, 0);
  write(folder / "c.toml", campaign_text("echo '{\"y\": 2}'", 2));
  const auto other = drydock(command + " --resume");
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.output, HasSubstr("holds another campaign"));
}

/// Starts the campaign, waits until `file` has a line, and sends `signal` to it alone.
void interrupted(const std::string& arguments, const std::filesystem::path& file,
                 const std::string& signal) {
  const std::string command = "cd " DRYDOCK_SOURCE_DIR "; " DRYDOCK_PROGRAM " " + arguments +
                              " >/dev/null 2>&1 & child=$!; while ! [ -s " + file.string() +
                              " ]; do :; done; kill -" + signal + " $child; wait $child; exit $?";
  const int status = std::system(command.c_str());
  EXPECT_NE(WEXITSTATUS(status), 0);
}

class CampaignEnd : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(By, CampaignEnd, testing::Values("INT", "KILL"));

// The fifth run would take longer than any test, and it is told so only the first time.
TEST_P(CampaignEnd, LosesNothingAndCountsNothingTwice) {
  const Folder folder;
  const std::string once = (folder / "once").string(), log = (folder / "log").string();
  write(folder / "c.toml",
        campaign_text("if [ {index} = 4 ] && mkdir " + once + "; then echo $$ > " + log +
                          "; exec sleep 1000; fi\necho '{\"y\": {index}}'",
                      8));
  const std::string arguments = campaign_in(folder) + " --jobs 1";
  interrupted(arguments, log, GetParam());
  const int sleeper = std::stoi(read_file(log));
  for (int i = 0; i < 500 && kill(sleeper, 0) == 0; ++i)  // the kernel needs a moment
    std::this_thread::sleep_for(std::chrono::milliseconds{10});
  EXPECT_NE(kill(sleeper, 0), 0) << "the run is still there";
  const auto status = drydock(arguments + " --status");
  EXPECT_THAT(status.output, HasSubstr("4 of 8 runs, 0 failed"));
  EXPECT_EQ(drydock(arguments + " --resume").exit_code, 0);
  EXPECT_THAT(column(folder / "out" / "results.sqlite", "SELECT count(*) || sum(y) FROM runs"),
              testing::ElementsAre("828.0"));
  const auto whole =
      drydock("campaign " + (folder / "c.toml").string() + " --out " + (folder / "whole").string());
  EXPECT_EQ(read_file(folder / "out" / "results.sqlite"),
            read_file(folder / "whole" / "results.sqlite"));
}

// A power cut may leave a part of a line, and whatever the disk had behind it.
TEST(CampaignProgram, AfterAHalfWrittenJournalOnlyItsLastRunIsRepeated) {
  const Folder folder;
  const std::string log = (folder / "log").string();
  write(folder / "c.toml", campaign_text("echo {index} >> " + log + "\necho '{\"y\": {x}}'", 6));
  const std::string command = campaign_in(folder) + " --jobs 1";
  EXPECT_EQ(drydock(command).exit_code, 0);
  const std::string undisturbed = read_file(folder / "out" / "results.sqlite");
  const auto journal = std::filesystem::directory_iterator(folder / "out" / "runs")->path();
  auto lines = read_file(journal);
  lines.replace(lines.rfind("\"index\"") + 12, std::string::npos, std::string(20, '\0'));
  write(journal, lines);
  std::filesystem::remove(folder / "out" / "results.sqlite");

  const auto resumed = drydock(command + " --resume");
  EXPECT_EQ(resumed.exit_code, 0) << resumed.output;
  EXPECT_THAT(resumed.output, HasSubstr("1 damaged lines in the journals"));
  EXPECT_EQ(read_file(log), "0\n1\n2\n3\n4\n5\n5\n");
  EXPECT_EQ(read_file(folder / "out" / "results.sqlite"), undisturbed);
}

TEST(CampaignProgram, ASecondCoordinatorIsRefusedWhileTheFirstIsAtWork) {
  const Folder folder;
  const std::string log = (folder / "log").string(), go = (folder / "go").string();
  write(folder / "c.toml", campaign_text("echo {index} >> " + log + "\nwhile ! [ -e " + go +
                                             " ]; do sleep 0.02; done\necho '{\"y\": {index}}'",
                                         4));
  const std::string command = campaign_in(folder) + " --jobs 2";
  std::jthread first([&] { EXPECT_EQ(drydock(command).exit_code, 0); });
  while (!std::filesystem::exists(log)) std::this_thread::yield();
  const auto second = drydock(command + " --resume");
  EXPECT_EQ(second.exit_code, 1);
  EXPECT_THAT(second.output, HasSubstr("another process is at work on this campaign; allowed: "));
  EXPECT_EQ(drydock(command + " --status").exit_code, 0);
  write(go, "");
  first.join();
  EXPECT_EQ(lines_in(log), 4u);
  EXPECT_EQ(drydock(command + " --resume").exit_code, 0);  // nothing is left to do
  EXPECT_EQ(lines_in(log), 4u);
}

}  // namespace
}  // namespace campaign_resume_test
