// A recording that a viewer of the page starts and stops.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/hil/program/running.hpp"
#include "tests/npm/node.hpp"

namespace recording_page_test {

using program::drydock;
using program::Folder;
using program::Running;
using testing::HasSubstr;
using testing::MatchesRegex;

TEST(RecordingPage, AViewerWhoMayStartsAndStopsARecordingThatCanBeRead) {
  DRYDOCK_NEEDS_NODE();
  if (std::system("command -v chromium >/dev/null") != 0) {
    ASSERT_EQ(std::getenv("CI"), nullptr) << "chromium is missing";
    GTEST_SKIP() << "chromium is not installed";
  }
  const Folder folder;
  const auto dives = (folder / "dives").string();
  const Running bench(folder, "run rig_config/rigs/demo.toml --serve 0 --allow-recording " + dives,
                      "run.txt");
  const auto screenshots = std::filesystem::path(DRYDOCK_SOURCE_DIR) / "build/screenshots";
  std::filesystem::create_directories(screenshots);
  const auto seen = drydock::test::run_node(
      "tests/hil/program/recording_page.cjs",
      {"/usr/bin/chromium", bench.line_from("live: "), (screenshots / "recording.png").string()});
  ASSERT_TRUE(seen.contains("after")) << seen << bench.output();
  EXPECT_TRUE(seen["errors"].empty()) << seen["errors"];
  EXPECT_LE(seen["overflow"], 0);
  EXPECT_THAT(seen["during"].get<std::string>(),
              MatchesRegex(".*/demo-[0-9TZ]+.mcap, since [0-9:]+ UTC, [0-9.]+ MB"));
  EXPECT_THAT(seen["after"].get<std::string>(), MatchesRegex("recording .* 0 lost"));
  const auto info = drydock("info " + dives + "/*.mcap");
  EXPECT_EQ(info.exit_code, 0) << info.output;
  EXPECT_THAT(info.output, HasSubstr("dvl"));
}

TEST(RecordingPage, IsOnlyWithAPage) {
  const auto nobody_looks = drydock("run rig_config/rigs/demo.toml --allow-recording dives");
  EXPECT_EQ(nobody_looks.exit_code, 2);
  EXPECT_THAT(nobody_looks.output, HasSubstr("--serve"));
}

}  // namespace recording_page_test
