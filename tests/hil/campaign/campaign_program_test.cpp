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

/// Slurm that is there, and an account that may not submit.
TEST(CampaignProgram, WhatSbatchRefusesLeavesNothingBehind) {
  const Folder folder;
  const auto tool = [&](const std::string& name, const std::string& does) {
    write(folder / name, "#!/bin/sh\n" + does + "\n");
    std::filesystem::permissions(folder / name, std::filesystem::perms::owner_all);
  };
  tool("scontrol", "echo 'MaxArraySize            = 1001'");
  tool("sbatch", "echo 'sbatch: error: invalid account' >&2; exit 1");
  const auto out = folder / "out";
  const std::string command = "campaign " DRYDOCK_SOURCE_DIR
                              "/rig_config/campaigns/turning.toml --engine slurm --out " +
                              out.string();
  const std::string path = "PATH=" + (folder / "").string() + ":/usr/bin:/bin";
  const auto refused = drydock(command, path);
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.output, HasSubstr("invalid account"));
  EXPECT_FALSE(std::filesystem::exists(out));
  std::filesystem::create_directories(out);
  write(out / "mine.txt", "kept");
  EXPECT_EQ(drydock(command, path).exit_code, 1);
  EXPECT_TRUE(std::filesystem::exists(out / "mine.txt"));
  EXPECT_FALSE(std::filesystem::exists(out / "slurm"));
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

/// Seconds since 1970, as a receiver tells them.
TEST(CampaignProgram, ItsTablesHaveTheDigitsBeforeThePointAndItsFilesAllOfThem) {
  const Folder folder;
  write(folder / "a.toml", campaign_text("echo '{\"y\": 1419009475.9375, \"x\": {x}}'", 5));
  const auto told =
      drydock("campaign " + (folder / "a.toml").string() + " --out " + (folder / "out").string());
  EXPECT_THAT(told.output, HasSubstr(" 1419009476 "));
  EXPECT_THAT(told.output, testing::Not(HasSubstr("e+09")));
  const auto summary = Json::parse(read_file(folder / "out" / "summary.json"));
  EXPECT_EQ(summary["figures"][0]["mean"], 1419009475.9375);
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
