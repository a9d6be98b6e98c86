#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iomanip>
#include <sstream>
#include <thread>

#include "drivers/live/page_files.hpp"
#include "tests/drivers/live/made_up_bench.hpp"
#include "tests/npm/node.hpp"

/// The page in headless Chromium, with a simulated bench.
namespace drydock::live {
namespace page_test {

namespace asio = boost::asio;
using std::chrono::milliseconds;

using nlohmann::json;
using testing::HasSubstr;
using testing::MatchesRegex;

struct Look {
  int width;
  const char* theme;
  const char* token = "";
};

/// Number of pixels in a figure of the screenshot.
int drawn(const json& figures, const std::string& title, const char* what) {
  return figures.contains(title) ? figures[title].value(what, 0) : -1;
}

void see_devices(const json& devices, int width) {
  ASSERT_EQ(devices.size(), 2U);
  const auto imu = devices[0].get<std::vector<std::string>>();
  const auto dvl = devices[1].get<std::vector<std::string>>();
  EXPECT_EQ(imu[1], "streaming");
  EXPECT_THAT(imu[width > 1000 ? 3 : 2], HasSubstr("100 of 100"));  // 99.98 with three digits
  EXPECT_EQ(dvl[1], "degraded fault damaged");
  EXPECT_THAT(dvl[2], HasSubstr("no bottom lock for 3 s"));
  EXPECT_THAT(dvl[width > 1000 ? 8 : 2],
              MatchesRegex(".*a bad checksum ?3 errors, the last at 22:13:[45][0-9] UTC"));
}

/// A finding is no device: it has its own list, and a badge in the row of its device.
void see_findings(const json& seen) {
  EXPECT_EQ(seen["findings"],
            "Findings dvl damaged since 22:13:20 UTC: frames arrive damaged: 12 damaged frames (at "
            "most 0) look at the cable");
}

/// A promise of an estimator is no device either.
void see_integrity(const json& estimators) {
  EXPECT_EQ(estimators,
            json::parse(R"([["leveling", "not valid", "roll ± 0.81°, pitch ± 0.5°"]])"));
}

/// The banner names only the faults in force. The plots also shade faults that have ended.
void see_faults(const json& seen) {
  EXPECT_THAT(seen["faults"].get<std::string>(),
              MatchesRegex("dvl: bit-errors one bit in 1000 is wrong in force since "
                           "22:13:[0-9][0-9] UTC, [0-9]+ s"));
  for (const auto& [title, figure] : seen["figures"].items()) {
    if (title == "Map" || title == "Satellites") continue;
    EXPECT_GT(figure["fault"], 400) << title;
  }
}

void see_curves(const json& figures) {
  EXPECT_GT(drawn(figures, "leveling: roll", "--c1"), 50);
  EXPECT_GT(drawn(figures, "leveling: roll", "--c2"), 50);  // the truth
  EXPECT_GT(drawn(figures, "leveling: roll", "band"), 200);
  EXPECT_GT(drawn(figures, "leveling: pitch", "--c1"), 50);
  for (const char* error : {"position error", "depth error", "velocity error", "heading error"}) {
    const auto title = std::string("leveling: ") + error;
    EXPECT_GT(drawn(figures, title, "--c1"), 20) << title;
    EXPECT_GT(drawn(figures, title, "band"), 500) << title;
  }
  EXPECT_THAT(figures["leveling: position error"]["legend"].get<std::string>(),
              MatchesRegex("north ± 3σ 2(.00[0-9])? east ± 3σ .*"));
  // An estimate of another time than each truth is compared with the truth between two.
  EXPECT_THAT(figures["late: position error"]["legend"].get<std::string>(),
              MatchesRegex("north ± 3σ 2(.00[0-9])? east ± 3σ .*"));
  EXPECT_GT(drawn(figures, "late: position error", "--c1"), 20);
  EXPECT_GT(drawn(figures, "late: pitch", "--c2"), 50);
  EXPECT_GT(drawn(figures, "dvl: velocity over the bed", "--c1"), 50);
  EXPECT_GT(drawn(figures, "dvl: velocity over the bed", "--c2"), 50);
  EXPECT_GT(drawn(figures, "imu: specific force", "--c3"), 50);
  EXPECT_GT(drawn(figures, "Depth", "--c2"), 20);  // the truth; the estimate is drawn over it
  EXPECT_THAT(figures["Depth"]["legend"].get<std::string>(), HasSubstr("leveling ± 3σ 5"));
  EXPECT_GT(drawn(figures, "Map", "--c1"), 20);
  EXPECT_GT(drawn(figures, "Satellites", "--ok"), 50);
  for (const auto& [title, figure] : figures.items()) {  // the axes have numbers and units
    if (title == "Satellites") continue;
    EXPECT_GT(figure["left"], 5) << title;
    EXPECT_GT(figure["under"], 60) << title;
  }
}

/// Nine in ten are inside the bound for 95 %. The bound has the colour of a second line.
void see_innovations(const json& figures, int before) {
  EXPECT_GT(drawn(figures, "leveling, log: innovation", "--c1"), 50);
  EXPECT_GT(drawn(figures, "leveling, log: innovation", "band"), 500);
  EXPECT_THAT(figures["leveling, dvl: innovation"]["legend"].get<std::string>(),
              MatchesRegex("forward, 95 % .* starboard, 95 % .* down, 95 % .*"));
  for (const char* source : {"log", "dvl"}) {
    const auto title = std::string("leveling, ") + source + ": NIS";
    EXPECT_GT(drawn(figures, title, "--c1"), 50) << title;
    EXPECT_GT(drawn(figures, title, "--c2"), 30) << title;
  }
  EXPECT_GT(drawn(figures, "leveling, log: NIS", "--c6"), 20);  // refused by the gate
  EXPECT_THAT(figures["leveling, log: NIS"]["caption"].get<std::string>(),
              MatchesRegex(".*(89|90|91) % of [0-9]+ inside"));
  const auto all = figures["leveling, dvl: NIS"]["caption"].get<std::string>();
  const auto at = all.find("100 % of ");
  ASSERT_NE(at, std::string::npos) << all;
  EXPECT_GT(std::stoi(all.substr(at + 9)), before);  // those before the page was open, too
}

class LivePage : public testing::TestWithParam<Look> {
 protected:
  static constexpr int steps_before = 400;  ///< 20 s that only the history has
  static constexpr int steps_live = 240;    ///< 12 s that the browser sees as they come

  void SetUp() override {
    DRYDOCK_NEEDS_NODE();
    if (std::system("command -v chromium >/dev/null") != 0) {
      ASSERT_EQ(std::getenv("CI"), nullptr) << "chromium is missing";
      GTEST_SKIP() << "chromium is not installed";
    }
    ASSERT_FALSE(server_.listen());
  }

  /// The bench stands still until the browser looks, which may need a minute, and at the end of
  /// what it has to show: a busy machine sees the same as a quick one, but later.
  void keep_stepping() {
    timer_.expires_after(milliseconds{50});
    timer_.async_wait([this](const boost::system::error_code& error) {
      if (error || stopped_) return;  // an expired timer can no longer be cancelled
      if (server_.counters().viewers > 0 && live_steps_ < steps_live) {
        bench_.step();
        ++live_steps_;
      }
      keep_stepping();
    });
  }

  json look(const Look& how) {
    for (int i = 0; i < steps_before; ++i) bench_.step();
    keep_stepping();
    const auto folder = std::filesystem::path(DRYDOCK_SOURCE_DIR) / "build/screenshots";
    std::filesystem::create_directories(folder);
    json seen;
    std::jthread browser([&] {
      seen = drydock::test::run_node(
          "tests/drivers/live/page.cjs",
          {"/usr/bin/chromium",
           "http://127.0.0.1:" + std::to_string(server_.port()) + "/?token=" + how.token,
           folder.string(), std::to_string(how.width), how.theme});
      asio::post(io_, [&] {
        stopped_ = true;
        server_.stop();
        timer_.cancel();
      });
    });
    io_.run();
    browser.join();
    return seen;
  }

  asio::io_context io_{1};
  Server server_{io_.get_executor(),
                 {.port = 0,
                  .token = GetParam().token,
                  .name = "drydock demo",
                  .history = std::chrono::minutes{5}},
                 page_files()};
  test::MadeUpBench bench_{server_};
  asio::steady_timer timer_{io_};
  int live_steps_ = 0;
  bool stopped_ = false;
};

TEST_P(LivePage, ShowsHealthFaultsEstimatesInnovationsAndMeasurementsAtThisWidthAndInThisLight) {
  auto seen = look(GetParam());
  ASSERT_TRUE(seen.contains("devices")) << seen;
  EXPECT_TRUE(seen["errors"].empty()) << seen["errors"];
  EXPECT_EQ(seen["rig"], "demo");
  EXPECT_EQ(seen["link"], "live");
  EXPECT_EQ(seen["orders"], false);  // this server accepts no orders
  EXPECT_EQ(seen["recording"], false);
  EXPECT_LE(seen["overflow"], 0);  // no horizontal scrolling
  EXPECT_TRUE(seen["overlaps"].empty()) << seen["overlaps"];
  EXPECT_TRUE(seen["cut"].empty()) << seen["cut"];
  EXPECT_EQ(seen["background"],
            std::string(GetParam().theme) == "dark" ? "rgb(17, 22, 28)" : "rgb(246, 247, 249)");
  see_devices(seen["devices"], GetParam().width);
  see_findings(seen);
  see_integrity(seen["estimators"]);
  see_faults(seen);
  see_curves(seen["figures"]);
  see_innovations(seen["figures"], steps_before);
}

/// Truths each 0.2 s of a motion of 3 m/s, as the history keeps them; estimates at other times.
TEST(LivePageTruths, AnEstimateMeetsTheTruthOfItsOwnTimeHoweverTheyCame) {
  DRYDOCK_NEEDS_NODE();
  const auto seen = drydock::test::run_node("tests/drivers/live/truths.cjs", {});
  ASSERT_FALSE(seen.empty());
  ASSERT_EQ(seen["off"].size(), 50U);  // each estimate found its truth
  for (const double off : seen["off"]) EXPECT_NEAR(off, 0, 1e-9);
  EXPECT_EQ(seen["in_a_hole"], json::parse("[[null, false]]"));
  EXPECT_EQ(seen["without"], json::parse("[[null, true], [null, true], [null, true]]"));
  EXPECT_EQ(seen["another_run"], json::parse("[[9, false]]"));
}

TEST(LivePageBounds, AreThoseThatBoostsDistributionsGive) {
  std::ostringstream bounds;
  bounds << std::fixed << std::setprecision(3) << "[0";
  for (const int degrees : {1, 2, 3})
    bounds << ", " << quantile(boost::math::chi_squared(degrees), 0.95);
  const auto files = page_files();
  const auto module = std::ranges::find(files, "/innovations.js", &PageFile::path);
  ASSERT_NE(module, files.end());
  EXPECT_THAT(std::string(module->content), HasSubstr("chiSquare95 = " + bounds.str() + "]"));
  EXPECT_NEAR(quantile(boost::math::normal(), 0.975), 1.96, 5e-5);
}

INSTANTIATE_TEST_SUITE_P(Looks, LivePage,
                         testing::Values(Look{1280, "light"}, Look{1280, "dark"},
                                         Look{390, "light"}, Look{390, "dark", "mine"}),
                         [](const auto& look) {
                           return std::string(look.param.theme) + std::to_string(look.param.width);
                         });

}  // namespace page_test
}  // namespace drydock::live
