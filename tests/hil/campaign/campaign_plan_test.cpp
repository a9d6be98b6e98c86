// Which run has which values, and what a campaign's file may say.
#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "hil/campaign/plan/figure_path.hpp"
#include "hil/campaign/plan/placeholders.hpp"
#include "hil/campaign/report/repeat.hpp"

namespace campaign_plan_test {
namespace {

using namespace drydock::campaign;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr auto head = R"([campaign]
name = "test"
command = "own {a} {b} --seed {seed}"
repetitions = 2
seed = 100
[[figure]]
name = "f"
at = "/f"
)";

CampaignConfig loaded(const std::string& text) {
  return load_campaign_text(text, "test.toml").value();
}

std::string problems(const std::string& text) {
  const auto campaign = load_campaign_text(text, "test.toml");
  std::string all;
  if (!campaign)
    for (const auto& problem : campaign.error())
      all += drydock::rig_config::to_string(problem) + "\n";
  return all;
}

const std::string lists = std::string(head) +
                          "[[parameter]]\nname = \"a\"\nlist = [\"x\", \"y z\"]\n"
                          "[[parameter]]\nname = \"b\"\nfrom = 0.0\nto = 0.3\ncount = 4\n";

std::string values_text(const Plan& plan, std::size_t index) {
  std::string text;
  for (const auto& value : plan.values_of(index)) text += to_text(value) + ";";
  return text;
}

TEST(CampaignPlan, TriesEveryCombinationOfListsAndGridsWithItsRepetitions) {
  const auto campaign = loaded(lists);
  const Plan plan(campaign);
  EXPECT_EQ(plan.runs(), 2u * 4 * 2);
  EXPECT_EQ(values_text(plan, 0), "x;0;");
  EXPECT_EQ(values_text(plan, 1), "x;0;");
  EXPECT_EQ(values_text(plan, 7), "x;0.3;");  // both ends of a grid are exact
  EXPECT_EQ(values_text(plan, 8), "y z;0;");
  EXPECT_EQ(plan.repetition_of(9), 1u);
  EXPECT_EQ(plan.seed_of(9), 109u);
  std::set<std::string> seen;
  for (std::size_t i = 0; i < plan.runs(); ++i) seen.insert(values_text(plan, i));
  EXPECT_EQ(seen.size(), 8u);
}

TEST(CampaignPlan, AValueWithABlankStaysOneWord) {
  const auto campaign = loaded(lists);
  EXPECT_THAT(command_of(campaign, 8, "dir"), ElementsAre("own", "y z", "0", "--seed", "108"));
  EXPECT_EQ(repeat_command(campaign, "c.toml", 8), "own 'y z' 0 --seed 108");
}

TEST(CampaignPlan, ARandomDrawDependsOnItsNameSeedAndIndexAlone) {
  const std::string draw = "[[parameter]]\nname = \"a\"\nuniform = [2.0, 4.0]\n";
  const std::string other = "[[parameter]]\nname = \"b\"\nnormal = [10.0, 0.5]\n";
  auto text = std::string(head);
  text.replace(text.find("repetitions = 2"), 15, "repetitions = 4000");
  const auto ab = loaded(text + draw + other), ba = loaded(text + other + draw);
  const Plan one(ab), two(ba);
  double sum = 0, squares = 0, uniform = 0;
  for (std::size_t i = 0; i < one.runs(); ++i) {
    EXPECT_EQ(one.values_of(i)[0], two.values_of(i)[1]);
    const double a = number_of(one.values_of(i)[0]), b = number_of(one.values_of(i)[1]);
    EXPECT_TRUE(a >= 2 && a < 4) << a;
    uniform += a, sum += b, squares += (b - 10) * (b - 10);
  }
  const double n = 4000;  // five standard errors of each
  EXPECT_NEAR(uniform / n, 3, 5 * 2 / std::sqrt(12 * n));
  EXPECT_NEAR(sum / n, 10, 5 * 0.5 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 0.25, 5 * 0.25 * std::sqrt(2 / n));
}

TEST(CampaignPlan, DrawnIntegersReachBothBounds) {
  auto text = std::string(head) +
              "[[parameter]]\nname = \"a\"\nintegers = [-1, 1]\n"
              "[[parameter]]\nname = \"b\"\nlog_uniform = [0.01, 100.0]\n";
  text.replace(text.find("repetitions = 2"), 15, "repetitions = 300");
  const auto campaign = loaded(text);
  std::set<double> seen;
  int below_one = 0;
  for (std::size_t i = 0; i < 300; ++i) {
    seen.insert(number_of(Plan(campaign).values_of(i)[0]));
    below_one += number_of(Plan(campaign).values_of(i)[1]) < 1;
  }
  EXPECT_THAT(seen, ElementsAre(-1, 0, 1));
  EXPECT_NEAR(below_one, 150, 5 * std::sqrt(75));  // half of the decades
}

TEST(CampaignFile, SaysWhereAndWhatIsWrong) {
  EXPECT_THAT(problems(std::string(head) + "[[parameter]]\nname = \"a\"\n"),
              HasSubstr("test.toml:9:1: /parameter: has no values, allowed: one of list"));
  EXPECT_THAT(problems(lists + "[[parameter]]\nname = \"c\"\nlist = [1]\nuniform = [0.0, 1.0]\n"),
              HasSubstr("'uniform' is a second way to choose values"));
  EXPECT_THAT(problems(lists + "[[parameter]]\nname = \"a\"\nlist = [1]\n"),
              HasSubstr("the name 'a' is taken"));
  EXPECT_THAT(problems(lists + "[[parameter]]\nname = \"Seed\"\nlist = [1]\n"),
              HasSubstr("the name 'seed' is taken"));
  EXPECT_THAT(problems(lists + "[[parameter]]\nname = \"c\"\nuniform = [2.0, 1.0]\n"),
              HasSubstr("the upper bound is below the lower one"));
  EXPECT_THAT(problems(lists + "[[parameter]]\nname = \"c\"\nfrom = 1.0\n"),
              HasSubstr("a grid needs 'from', 'to' and 'count'"));
  EXPECT_THAT(problems(head), HasSubstr("test.toml:3:11: /campaign/command: there is no '{a}', "
                                        "allowed: index, repetition, seed, json, folder"));
  EXPECT_THAT(problems("[campaign]\nname = \"x\"\n"), HasSubstr("key 'command' is missing"));
}

// Every run would get the same nan, or none would begin, and the report would not say why.
TEST(CampaignFile, RefusesValuesThatAreNoNumbersAndGridsWithoutPoints) {
  const auto refused = [](const std::string& values) {
    return problems(std::string(head) + "[[parameter]]\nname = \"a\"\n" + values + "\n");
  };
  EXPECT_THAT(refused("list = [1.0, nan]"), HasSubstr("/list/1: nan and inf are not allowed"));
  EXPECT_THAT(refused("uniform = [0.0, inf]"), HasSubstr("nan and inf are not allowed"));
  EXPECT_THAT(refused("normal = [nan, 1.0]"), HasSubstr("nan and inf are not allowed"));
  EXPECT_THAT(refused("from = nan\nto = 1.0\ncount = 3"), HasSubstr("nan and inf are not allowed"));
  EXPECT_THAT(refused("list = []"), HasSubstr("/list: has 0 values, allowed: 1 to 10000"));
  EXPECT_THAT(refused("from = 0.0\nto = 1.0\ncount = 0"),
              HasSubstr("/count: 0 is out of range, allowed: 2 to 10000"));
}

TEST(CampaignFile, TheShippedOnesCanBeUsed) {
  int found = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(DRYDOCK_SOURCE_DIR "/rig_config/campaigns")) {
    const auto campaign = load_campaign(entry.path().string());
    EXPECT_TRUE(campaign) << entry.path();
    ++found;
  }
  EXPECT_GE(found, 4);
}

TEST(CampaignFile, RefusesMoreRunsThanAnIndexHolds) {
  std::string text = head;
  text.replace(text.find("repetitions = 2"), 15, "repetitions = 10000000");
  for (const char* name : {"a", "b", "c", "d"})
    text += std::string("[[parameter]]\nname = \"") + name +
            "\"\nfrom = 0.0\nto = 1.0\ncount = 10000\n";
  EXPECT_THAT(problems(text), HasSubstr("are more runs than 1000000000"));
}

TEST(CampaignFile, RefusesAMisspeltPlaceholderInAFile) {
  const auto refused = [](const std::string& text) {
    return problems(lists +
                    "[[parameter]]\nname = \"delay\"\nlist = [1]\n[[file]]\nname = \"f\"\n" +
                    "text = '" + text + "'\n");
  };
  EXPECT_THAT(refused("seconds = {dely}"),
              HasSubstr("/file/0/text: there is no '{dely}' (did you mean 'delay'?)"));
  EXPECT_THAT(refused("{sed} {jsn}"), HasSubstr("there is no '{jsn}' (did you mean 'json'?)"));
  EXPECT_EQ(refused("{delay} ${dely} {errors = 1} {print} {x}"), "");
}

TEST(CampaignFile, LeavesTheBracesOfJsonInACommandAndRefusesASingleName) {
  const auto with_command = [](const std::string& command) {
    std::string text = lists + "[[parameter]]\nname = \"delay\"\nlist = [1]\n";
    const auto at = text.find("command = ");
    return text.replace(at, text.find('\n', at) - at, "command = '" + command + "'");
  };
  EXPECT_EQ(problems(with_command(R"(echo {"y": {delay}} {"a":1} ${HOME} {} {a,b})")), "");
  EXPECT_THAT(problems(with_command("echo {dely}")), HasSubstr("there is no '{dely}'"));
  const auto campaign = loaded(with_command(R"(echo {"y":{a}})"));
  EXPECT_EQ(command_of(campaign, 2, "dir").at(1), R"({"y":x})");
}

TEST(CampaignFile, FillsTheFilesOfARun) {
  const auto campaign =
      loaded(lists + "[[file]]\nname = \"in.toml\"\ntext = \"a = '{a}'\\nb = { c = {b} }\"\n");
  EXPECT_EQ(filled(campaign, 2, "dir", campaign.files[0].text), "a = 'x'\nb = { c = 0.1 }");
  EXPECT_EQ(filled(campaign, 2, "dir", "{file:in.toml} {json}"), "dir/in.toml dir/figures.json");
  EXPECT_EQ(repeat_command(campaign, "my c.toml", 2), "drydock campaign 'my c.toml' --only 2");
}

TEST(CampaignFigure, IsFoundByNameIndexAndNumberOfElements) {
  const auto json = nlohmann::json::parse(
      R"({"devices": [{"name": "imu", "ok": true}, {"name": "dvl", "rate": 5.5}], "none": null, "t": "x"})");
  EXPECT_EQ(figure_at(json, "/devices/dvl/rate"), 5.5);
  EXPECT_EQ(figure_at(json, "/devices/1/rate"), 5.5);
  EXPECT_EQ(figure_at(json, "/devices/imu/ok"), 1);
  EXPECT_EQ(figure_at(json, "/devices/#"), 2);
  for (const char* path : {"/devices/2", "/devices", "/none", "/t", "/devices/gps/rate", "/none/x"})
    EXPECT_EQ(figure_at(json, path), std::nullopt) << path;
}

}  // namespace
}  // namespace campaign_plan_test
