#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/hil/campaign/made_campaign.hpp"

/// The command as a person runs it.
namespace campaign_program_test {
namespace {

using namespace made_campaign;
using program::drydock;
using program::Folder;
using program::read_file;
using testing::HasSubstr;
using Json = nlohmann::json;

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
