// A viewer sets faults: in a browser by clicks, and through Foxglove's own client.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/hil/program/running.hpp"
#include "tests/npm/node.hpp"

namespace fault_page_test {

using nlohmann::json;
using program::drydock;
using program::Folder;
using program::Running;
using testing::Contains;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

const std::string demo = "rig_config/rigs/demo.toml";

void see_look(const json& look) {
  EXPECT_LE(look["overflow"], 0) << look["look"];  // no horizontal scrolling
  EXPECT_TRUE(look["overlaps"].empty()) << look["look"] << look["overlaps"];
  EXPECT_TRUE(look["outside"].empty()) << look["look"] << look["outside"];
  EXPECT_GE(look["lowest"], 30) << look["look"];   // high enough for a finger
  EXPECT_GT(look["button"], 500) << look["look"];  // pixels of the button's colour; text covers
                                                   // some
  EXPECT_GT(look["written"], 25) << look["look"];
  EXPECT_GT(look["banner"], 3000) << look["look"];
}

TEST(FaultPage, AFaultIsSetAndClearedByHandAndTheDeviceChangesItsState) {
  DRYDOCK_NEEDS_NODE();
  if (std::system("command -v chromium >/dev/null") != 0) {
    ASSERT_EQ(std::getenv("CI"), nullptr) << "chromium is missing";
    GTEST_SKIP() << "chromium is not installed";
  }
  const Folder folder;
  const Running bench(folder, "run " + demo + " --serve 0 --allow-faults", "run.txt");
  const auto screenshots = std::filesystem::path(DRYDOCK_SOURCE_DIR) / "build/screenshots";
  std::filesystem::create_directories(screenshots);
  const auto seen = drydock::test::run_node(
      "tests/hil/program/fault_page.cjs",
      {"/usr/bin/chromium", bench.line_from("live: "), screenshots.string()});
  ASSERT_TRUE(seen.contains("cleared")) << seen << bench.output();
  EXPECT_TRUE(seen["errors"].empty()) << seen["errors"];
  EXPECT_TRUE(seen["nameless"].empty()) << seen["nameless"];
  EXPECT_THAT(seen["words"].get<std::vector<std::string>>(), Contains("bottom-lost"));
  EXPECT_THAT(seen["words"].get<std::vector<std::string>>(), Not(Contains("satellites-blocked")));
  EXPECT_EQ(seen["refused"], "refused: probability: 2 is out of range, allowed: 0 to 1");
  EXPECT_EQ(seen["set"], "set: dvl: hang, until cleared");
  EXPECT_THAT(seen["before"].get<std::string>(), HasSubstr("streaming"));
  EXPECT_THAT(seen["during"].get<std::string>(), MatchesRegex(".*stale fault.*"));
  EXPECT_THAT(seen["banner"].get<std::string>(), HasSubstr("dvl: hang"));
  EXPECT_THAT(seen["after"].get<std::string>(), HasSubstr("streaming"));
  EXPECT_EQ(seen["cleared"], "cleared: 1");
  ASSERT_EQ(seen["looks"].size(), 4U);
  for (const auto& look : seen["looks"]) see_look(look);
  EXPECT_THAT(bench.output(), HasSubstr(" s fault set: dvl: hang"));
  EXPECT_THAT(bench.output(), HasSubstr(" s fault cleared: dvl: hang"));
}

json call(const std::string& url, const json& calls) {
  return drydock::test::run_node("tests/drivers/live/call.cjs",
                                 {"ws" + url.substr(std::string("http").size()), calls.dump()});
}

TEST(FaultPage, OfDriversAsksTheProgramThatPlaysTheDevices) {
  DRYDOCK_NEEDS_NODE();
  const Folder folder;
  const Running drive(folder, "drive " + demo + " --serve 0 --allow-faults --token mine",
                      "drive.txt");
  const auto url = drive.line_from("live: ");
  const json list{"/drydock/faults/list", json::object()};
  const auto alone = call(url, json::array({list}));
  EXPECT_EQ(alone["answers"][0]["failure"],
            "no bench of rig \"demo\" runs here; start one: drydock emulate " + demo);
  const Running emulate(folder, "emulate " + demo, "emulate.txt");
  ASSERT_FALSE(emulate.line_from("imu: ").empty()) << emulate.output();
  const json hang{{"device", "depth"}, {"fault", "hang"}, {"for", "1min"}};
  const auto set = call(
      url, json::array({{"/drydock/faults/set", hang},
                        {"/drydock/faults/set", {{"device", "depth"}, {"fault", "bottom-lost"}}},
                        list}));
  ASSERT_EQ(set["answers"].size(), 3U) << set << emulate.output();
  EXPECT_EQ(set["answers"][0]["response"]["lines"][0], "set: depth: hang, for 60 s");
  EXPECT_THAT(set["answers"][1]["failure"].get<std::string>(),
              HasSubstr("only a dvl hears the sea bed"));
  EXPECT_EQ(set["answers"][2]["response"]["faults"][0]["words"], "depth: hang");
  EXPECT_EQ(emulate.line_from(" s fault set: depth"), ": hang");
  const auto shown = drydock::test::run_node("tests/drivers/live/watch.cjs",
                                             {"ws" + url.substr(4), "150", "", "/drydock/faults"});
  EXPECT_EQ(shown["messages"]["/drydock/faults"]["value"]["faults"][0]["fault"], "hang")
      << shown["messages"];
}

TEST(FaultPage, IsRefusedWhereNothingCanBeSet) {
  const auto nobody_looks = drydock("run " + demo + " --allow-faults");
  EXPECT_EQ(nobody_looks.exit_code, 2);
  EXPECT_THAT(nobody_looks.output, HasSubstr("--serve"));
  const Folder folder;
  const auto pier = (folder / "pier.toml").string();
  std::ofstream(pier) << "[rig]\nname = \"pier\"\n[[device]]\nname = \"dvl\"\nkind = \"dvl\"\n"
                         "protocol = \"pd0\"\nrate_hz = 5\n"
                         "link = \"serial:/dev/ttyUSB7?baud=115200\"\n";
  for (const std::string command : {"run ", "drive "}) {
    const auto real = drydock(command + pier + " --serve 0 --allow-faults");
    EXPECT_EQ(real.exit_code, 1);
    EXPECT_THAT(real.output, HasSubstr("--allow-faults: no device of " + pier + " is emulated"));
    EXPECT_THAT(real.output, Not(HasSubstr("live: ")));
  }
}

}  // namespace fault_page_test
