#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/hil/campaign/made_campaign.hpp"

/// Runs that fail or have no figure, with their reason.
namespace campaign_failures_test {
namespace {

using namespace made_campaign;
using program::drydock;
using program::Folder;
using program::read_file;
using testing::HasSubstr;
using Json = nlohmann::json;

TEST(CampaignProgram, SignalsTimeoutsAndMissingFiguresAreFailuresWithTheirReason) {
  const Folder folder;
  auto text = campaign_text(
      "case {index} in 0) kill -9 $$;; 1) exec sleep 1000;; 2) echo no json;; 3) echo '{\"z\": "
      "1}';; *) echo '{\"y\": 1}'; exit 1;; esac",
      5);
  text.insert(text.find("repetitions"), "timeout_s = 0.3\n");
  write(folder / "c.toml", text);
  const auto said = drydock(campaign_in(folder));
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(
      column(folder / "out" / "results.sqlite", "SELECT failure FROM runs ORDER BY \"index\""),
      testing::ElementsAre("ended by signal 9", "took longer than 0.3 s", HasSubstr("no JSON came"),
                           "none of the figures is in its JSON", ""));
}

/// What the only run of a command failed with.
std::string failure_of(const Folder& folder, const std::string& shell) {
  write(folder / "c.toml", campaign_text(shell, 1));
  drydock(campaign_in(folder));
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

TEST(CampaignProgram, QuotesInACommandHoldItsBlanksTogether) {
  const Folder folder;
  auto text = campaign_text("printf '{\"y\": %s}' $#", 1);
  text.replace(text.find("command = "), 28, "command = '''sh {file:run.sh} \"a b\" 'c d' '' '''");
  write(folder / "c.toml", text);
  ASSERT_EQ(drydock(campaign_in(folder)).exit_code, 0);
  EXPECT_EQ(column(folder / "out" / "results.sqlite", "SELECT y FROM runs").at(0), "3.0");

  text.replace(text.find("'' '''"), 6, "' '''");
  write(folder / "c.toml", text);
  const auto said = drydock("check " + (folder / "c.toml").string());
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_THAT(said.output, HasSubstr("/campaign/command: a quote is not closed"));
}

/// Hours of runs would be for nothing.
TEST(CampaignProgram, AnEarlierCampaignThatIsNotThereIsSaidBeforeTheFirstRun) {
  const Folder folder;
  write(folder / "c.toml", campaign_text("echo '{\"y\": 1}'", 2));
  const auto said = drydock(campaign_in(folder) + " --compare " + (folder / "none").string());
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_THAT(said.output, HasSubstr("--compare: "));
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

/// A wrong --out would look as a campaign that does not get on.
TEST(CampaignProgram, StatusAndCancelSayWhereNothingOfTheCampaignIs) {
  const Folder folder;
  write(folder / "c.toml", campaign_text("echo '{\"y\": 1}'", 2));
  const auto asked = [&](const std::string& option) {
    return drydock(campaign_in(folder) + " " + option);
  };
  for (const char* option : {"--status", "--cancel"}) {
    const auto said = asked(option);
    EXPECT_EQ(said.exit_code, 2);
    EXPECT_THAT(said.output, HasSubstr("out has no campaign; allowed: --out with a folder"));
  }
  ASSERT_EQ(asked("").exit_code, 0);
  const auto cancelled = asked("--cancel");
  EXPECT_EQ(cancelled.exit_code, 1);
  EXPECT_THAT(cancelled.output, HasSubstr("out has no jobs of Slurm"));
  write(folder / "c.toml", campaign_text("echo '{\"y\": 1}'", 3));
  const auto changed = asked("--status");
  EXPECT_EQ(changed.exit_code, 2);
  EXPECT_THAT(changed.output, HasSubstr("or this one before a change; allowed: its own file"));
}

TEST(CampaignProgram, AScriptOfTheCampaignMayWriteTheJsonWhereItIsRead) {
  const Folder folder;
  write(folder / "c.toml",
        campaign_text("echo 'this is no JSON'\necho '{\"y\": {index}}' > {json}", 3));
  const auto said = drydock(campaign_in(folder));
  EXPECT_EQ(said.exit_code, 0) << said.output;
  EXPECT_THAT(column(folder / "out" / "results.sqlite", "SELECT sum(y) FROM runs"),
              testing::ElementsAre("3.0"));
}

TEST(CampaignProgram, AProgramThatIsNotThereIsNamed) {
  const Folder folder;
  auto text = campaign_text("", 1);
  text.replace(text.find("sh {file:run.sh}"), 16, "no-such-program-here");
  write(folder / "c.toml", text);
  const auto said = drydock(campaign_in(folder));
  EXPECT_THAT(said.output, HasSubstr("exit code 127: cannot start no-such-program-here: No such "
                                     "file or directory"));
}

// Slurm does so with all programs of a task that is cancelled.
TEST(CampaignProgram, ARunThatIsToldToEndIsMissingNotFailed) {
  const Folder folder;
  write(folder / "c.toml",
        campaign_text("[ {index} != 1 ] || kill -TERM $$\necho '{\"y\": 1}'", 3));
  const auto said = drydock(campaign_in(folder));
  EXPECT_EQ(said.exit_code, 1);
  EXPECT_THAT(said.output, HasSubstr("0 of 3 runs failed, 1 are missing"));
}

TEST(CampaignProgram, AFigureThatARunDoesNotHaveIsSaidAndExitsWith1) {
  const Folder folder;
  auto text = campaign_text(
      "case {index} in 1|2) echo '{\"y\": 1}';; *) echo '{\"y\": 1, \"z\": 1}';; esac", 4);
  write(folder / "c.toml", text + "[[figure]]\nname = \"zed\"\nat = \"/z\"\n" +
                               "[[figure]]\nname = \"misspelt\"\nat = \"/yy\"\n");
  const auto said = drydock(campaign_in(folder));
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

}  // namespace
}  // namespace campaign_failures_test
