// The command as a person runs it. A run is a shell script here, so that it takes no time.
#include <gmock/gmock.h>
#include <sqlite3.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/hil/program/program.hpp"

namespace campaign_program_test {
namespace {

using program::drydock;
using program::Folder;
using program::read_file;
using testing::HasSubstr;
using Json = nlohmann::json;

/// A campaign of `runs` runs of a shell line.
std::string campaign_text(const std::string& shell, int runs) {
  return "[campaign]\nname = \"test\"\nrepetitions = " + std::to_string(runs) +
         "\ncommand = \"sh {file:run.sh}\"\n[[file]]\nname = \"run.sh\"\ntext = '''" + shell +
         "'''\n[[parameter]]\nname = \"x\"\nuniform = [0.0, 1.0]\n[[figure]]\nname = \"y\"\nat = "
         "\"/y\"\n";
}

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

/// Values of the first column of a query.
std::vector<std::string> column(const std::filesystem::path& store, const std::string& sql) {
  sqlite3* handle = nullptr;
  std::vector<std::string> values;
  sqlite3_open(store.c_str(), &handle);
  sqlite3_exec(
      handle, sql.c_str(),
      [](void* into, int, char** cells, char**) {
        static_cast<std::vector<std::string>*>(into)->emplace_back(cells[0] ? cells[0] : "NULL");
        return 0;
      },
      &values, nullptr);
  sqlite3_close(handle);
  return values;
}

std::size_t lines_in(const std::filesystem::path& file) {
  const auto text = read_file(file);
  return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

TEST(CampaignProgram, WithoutSlurmItsEngineLeavesNothingBehind) {
  const Folder folder, empty;
  const auto out = folder / "out";
  const auto refused = drydock("campaign " DRYDOCK_SOURCE_DIR
                               "/rig_config/campaigns/turning.toml --engine slurm --out " +
                                   out.string(),
                               "PATH=" + (empty / "").string());
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.output, HasSubstr("Slurm is not installed here"));
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(CampaignProgram, OneAndSeveralAtATimeGiveTheSameBytes) {
  const Folder folder;
  const std::string file = DRYDOCK_SOURCE_DIR "/rig_config/campaigns/turning.toml";
  const auto one = drydock("campaign " + file + " --jobs 1 --out " + (folder / "one").string());
  const auto many = drydock("campaign " + file + " --jobs 5 --out " + (folder / "many").string());
  EXPECT_EQ(one.exit_code, 0) << one.output;
  EXPECT_EQ(many.exit_code, 0) << many.output;
  for (const char* name : {"results.sqlite", "summary.json", "index.html"})
    EXPECT_EQ(read_file(folder / "one" / name), read_file(folder / "many" / name)) << name;
}

TEST(CampaignProgram, ARowHasTheFiguresOfTheCommandRunAlone) {
  const Folder folder;
  const std::string file = DRYDOCK_SOURCE_DIR "/rig_config/campaigns/turning.toml";
  drydock("campaign " + file + " --out " + (folder / "out").string());
  const auto summary = Json::parse(read_file(folder / "out" / "summary.json"));
  const auto worst = summary["figures"][1]["worst"][0];
  const std::string command = worst["command"];
  ASSERT_TRUE(command.starts_with("drydock maneuver")) << command;
  const auto alone = drydock(command.substr(command.find(' ') + 1));
  EXPECT_EQ(Json::parse(alone.output)["steady_roll_deg"], worst["value"]);
  const auto rows = column(folder / "out" / "results.sqlite",
                           "SELECT speed || ' ' || rudder FROM runs WHERE \"index\" = 14");
  EXPECT_THAT(rows, testing::ElementsAre("2.0 20"));
}

TEST(CampaignProgram, ComparesWithAnEarlierCampaignRunByRun) {
  const Folder folder;
  write(folder / "a.toml", campaign_text("echo '{\"y\": {x}}'", 20));
  write(folder / "b.toml", campaign_text("echo '{\"y\": 1{x}}'", 20));  // 0.5 becomes 10.5
  drydock("campaign " + (folder / "a.toml").string() + " --out " + (folder / "a").string());
  const auto later = drydock("campaign " + (folder / "b.toml").string() + " --out " +
                             (folder / "b").string() + " --compare " + (folder / "a").string());
  EXPECT_EQ(later.exit_code, 0) << later.output;
  const auto since = Json::parse(read_file(folder / "b" / "summary.json"))["since_earlier"][0];
  EXPECT_EQ(since["verdict"], "worse");
  EXPECT_EQ(since["paired"], true);
  EXPECT_NEAR(since["worse_by"]["median"], 10, 1e-9);
  EXPECT_THAT(later.output, HasSubstr("probability of at most 5 %"));
}

TEST(CampaignProgram, AFailedRunIsNamedAndResumeRunsItAgainAlone) {
  const Folder folder;
  const std::string log = (folder / "log").string(), switched = (folder / "switch").string();
  write(folder / "c.toml",
        campaign_text("echo {index} >> " + log + "\nif [ {index} = 3 ] && ! [ -e " + switched +
                          " ]; then echo broken >&2; exit 5; fi\necho '{\"y\": {index}}'",
                      6));
  const std::string command =
      "campaign " + (folder / "c.toml").string() + " --out " + (folder / "out").string();
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
  const std::string command =
      "campaign " + (folder / "c.toml").string() + " --out " + (folder / "out").string();
  write(folder / "c.toml", campaign_text("echo '{\"y\": 1}'", 2));
  EXPECT_EQ(drydock(command).exit_code, 0);
  write(folder / "c.toml", campaign_text("echo '{\"y\": 2}'", 2));
  const auto other = drydock(command + " --resume");
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.output, HasSubstr("holds another campaign"));
}

TEST(CampaignProgram, SignalsTimeoutsAndMissingFiguresAreFailuresWithTheirReason) {
  const Folder folder;
  auto text = campaign_text(
      "case {index} in 0) kill -9 $$;; 1) exec sleep 1000;; 2) echo no json;; 3) echo '{\"z\": "
      "1}';; *) echo '{\"y\": 1}'; exit 1;; esac",
      5);
  text.insert(text.find("repetitions"), "timeout_s = 0.3\n");
  write(folder / "c.toml", text);
  const auto said =
      drydock("campaign " + (folder / "c.toml").string() + " --out " + (folder / "out").string());
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(
      column(folder / "out" / "results.sqlite", "SELECT failure FROM runs ORDER BY \"index\""),
      testing::ElementsAre("ended by signal 9", "took longer than 0.3 s", HasSubstr("no JSON came"),
                           "none of the figures is in its JSON", ""));
}

TEST(CampaignProgram, AFigureThatARunDoesNotHaveIsSaidAndExitsWith1) {
  const Folder folder;
  auto text = campaign_text(
      "case {index} in 1|2) echo '{\"y\": 1}';; *) echo '{\"y\": 1, \"z\": 1}';; esac", 4);
  write(folder / "c.toml", text + "[[figure]]\nname = \"zed\"\nat = \"/z\"\n" +
                               "[[figure]]\nname = \"misspelt\"\nat = \"/yy\"\n");
  const auto said =
      drydock("campaign " + (folder / "c.toml").string() + " --out " + (folder / "out").string());
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.output,
              HasSubstr("figure 'zed': 2 of 4 runs have no number at /z, the first is run 1"));
  EXPECT_THAT(
      said.output,
      HasSubstr("figure 'misspelt': 4 of 4 runs have no number at /yy, the first is run 0"));
  const auto summary = Json::parse(read_file(folder / "out" / "summary.json"));
  EXPECT_EQ(summary["lacking"].size(), 2u);
  EXPECT_EQ(summary["lacking"][1],
            Json({{"figure", "misspelt"}, {"at", "/yy"}, {"runs", 4}, {"first_index", 0}}));
}

/// What the only run of a command failed with.
std::string failure_of(const Folder& folder, const std::string& shell) {
  write(folder / "c.toml", campaign_text(shell, 1));
  drydock("campaign " + (folder / "c.toml").string() + " --out " + (folder / "out").string());
  auto failure = column(folder / "out" / "results.sqlite", "SELECT failure FROM runs").at(0);
  std::filesystem::remove_all(folder / "out");
  return failure;
}

TEST(CampaignProgram, TheReasonOfAFailureIsInItsFirstOrLastLine) {
  const Folder folder;
  EXPECT_EQ(failure_of(folder, "echo the reason >&2; echo Run with --help >&2; exit 2"),
            "exit code 2: the reason / Run with --help");
  EXPECT_EQ(failure_of(folder, "printf 'Traceback\\n a\\n b\\nValueError: x\\n' >&2; exit 2"),
            "exit code 2: Traceback / ... / ValueError: x");
  EXPECT_EQ(failure_of(folder, "echo said elsewhere; exit 2"), "exit code 2: said elsewhere");
  EXPECT_EQ(failure_of(folder, "exit 2"), "exit code 2: it printed nothing");
  EXPECT_EQ(failure_of(folder, "exec no-such-program-here").substr(0, 14), "exit code 127:");
}

TEST(CampaignProgram, AProgramThatIsNotThereIsNamed) {
  const Folder folder;
  auto text = campaign_text("", 1);
  text.replace(text.find("sh {file:run.sh}"), 16, "no-such-program-here");
  write(folder / "c.toml", text);
  const auto said =
      drydock("campaign " + (folder / "c.toml").string() + " --out " + (folder / "out").string());
  EXPECT_THAT(said.output, HasSubstr("exit code 127: cannot start no-such-program-here: No such "
                                     "file or directory"));
}

// Slurm does so with all programs of a task that is cancelled.
TEST(CampaignProgram, ARunThatIsToldToEndIsMissingNotFailed) {
  const Folder folder;
  write(folder / "c.toml",
        campaign_text("[ {index} != 1 ] || kill -TERM $$\necho '{\"y\": 1}'", 3));
  const auto said =
      drydock("campaign " + (folder / "c.toml").string() + " --out " + (folder / "out").string());
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.output, HasSubstr("0 of 3 runs failed, 1 are missing"));
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
  const std::string arguments =
      "campaign " + (folder / "c.toml").string() + " --jobs 1 --out " + (folder / "out").string();
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
  const std::string command =
      "campaign " + (folder / "c.toml").string() + " --jobs 1 --out " + (folder / "out").string();
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
  const std::string command =
      "campaign " + (folder / "c.toml").string() + " --jobs 2 --out " + (folder / "out").string();
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

TEST(CampaignProgram, OneRunAloneLeavesItsFilesAndSaysItsFigures) {
  const Folder folder;
  write(folder / "c.toml", campaign_text("echo '{\"y\": {index}.5}'", 8));
  const std::string arguments = "campaign " + (folder / "c.toml").string() + " --only ";
  const auto said = drydock(arguments + "7 --out " + (folder / "seven").string());
  EXPECT_EQ(said.exit_code, 0);
  EXPECT_EQ(said.output, "y 7.5\n");
  EXPECT_EQ(read_file(folder / "seven" / "run.sh"), "echo '{\"y\": 7.5}'");
  EXPECT_EQ(drydock(arguments + "8").exit_code, 2);
}

}  // namespace
}  // namespace campaign_program_test
