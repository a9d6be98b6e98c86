#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "hil/report/html.hpp"
#include "hil/report/table.hpp"
#include "hil/report/write_file.hpp"
#include "tests/npm/node.hpp"

/// A report in headless Chromium.
namespace page_test {

using drydock::report::Curve;
using drydock::report::Figure;
using nlohmann::json;
using testing::HasSubstr;

struct Look {
  int width;
  const char* theme;
};

Figure line(const std::string& title, std::vector<double> x, std::vector<double> y) {
  return {title, "time [s]", "m", {{"value", std::move(x), std::move(y)}}};
}

/// Two plots over the same time, a depth, a spectrum, and a track of 200 m by 100 m.
std::string report() {
  auto rising = line("rising", {0, 50, 100}, {0, 5, 10});
  rising.shades = {{20, 30}};
  rising.curves.push_back({"3 sigma", {0, 50, 100}, {1, 2, 3}, true});
  auto depth = line("depth", {0, 60, 100}, {0, 0.0011, 0.0017});
  depth.y_down = true;
  Figure spectrum{"spectrum", "Hz", "m/s", {{"", {0.01, 1, 100}, {1e-4, 1e-3, 1}}}};
  spectrum.log_x = spectrum.log_y = true;
  Figure track{"track", "east [m]", "north [m]", {{"path", {0, 200, 200}, {0, 0, 100}}}};
  track.curves.push_back({"fixes", {10, 190}, {1, 50}, false, true});
  track.equal_scales = true;
  std::string body = "<p>A sentence.</p>";
  for (const auto& figure : {rising, depth, spectrum, track})
    body += drydock::report::html::figure(figure);
  body += drydock::report::to_html({"wide",
                                    {"device", "state", "source", "good", "bad", "rate", "age"},
                                    {{"dvl", "streaming", "a long line of words that goes on",
                                      "1234567", "12", "5.00 of 5.00 Hz", "0.123 s"}},
                                    ""});
  return drydock::report::html::page("made up", body);
}

class ReportPage : public testing::TestWithParam<Look> {
 protected:
  void SetUp() override {
    DRYDOCK_NEEDS_NODE();
    if (std::system("command -v chromium >/dev/null") != 0) {
      ASSERT_EQ(std::getenv("CI"), nullptr) << "chromium is missing";
      GTEST_SKIP() << "chromium is not installed";
    }
  }
};

std::vector<double> numbers(const json& figure, const char* key) { return figure[key]; }

TEST_P(ReportPage, IsOneFileWhosePlotsAreToScaleAndCanBeZoomed) {
  const auto folder = std::filesystem::path(DRYDOCK_SOURCE_DIR) / "build/screenshots";
  const auto name = std::string("report-") + std::to_string(GetParam().width) + GetParam().theme;
  const auto file = folder / (name + ".html");
  drydock::report::write_file(file, report());
  const auto seen = drydock::test::run_node(
      "tests/hil/report/page.cjs",
      {"/usr/bin/chromium", file.string(), (folder / (name + ".png")).string(),
       std::to_string(GetParam().width), GetParam().theme});
  ASSERT_TRUE(seen.contains("whole")) << seen;
  EXPECT_TRUE(seen["errors"].empty()) << seen["errors"];
  EXPECT_EQ(seen["loaded"].size(), 1U) << seen["loaded"];  // the file itself
  EXPECT_LE(seen["overflow"], 0);
  EXPECT_TRUE(seen["cut"].empty()) << seen["cut"];  // no column is out of sight
  const auto cells = seen["cells"].get<std::string>();
  EXPECT_THAT(cells, HasSubstr("5.00 of 5.00 Hz"));
  EXPECT_EQ(seen["labels"].get<std::string>(), GetParam().width < 560 ? "rate" : "");
  EXPECT_EQ(seen["background"],
            std::string(GetParam().theme) == "dark" ? "rgb(13, 17, 23)" : "rgb(255, 255, 255)");

  const auto& whole = seen["whole"];
  ASSERT_EQ(whole.size(), 4U);
  EXPECT_EQ(numbers(whole[0], "x"), (std::vector<double>{0, 100}));
  EXPECT_TRUE(whole[0]["rising"]);
  EXPECT_FALSE(whole[1]["rising"]);  // depth grows downwards
  std::vector<double> deep;
  for (const auto& mark : whole[1]["marks"][1]) deep.push_back(std::stod(mark.get<std::string>()));
  ASSERT_GT(deep.size(), 2U);
  for (std::size_t i = 2; i < deep.size(); ++i)  // marks at equal distances say equal ones
    EXPECT_NEAR(deep[i] - deep[i - 1], deep[1] - deep[0], 1e-9) << whole[1]["marks"][1];
  EXPECT_LT(numbers(whole[2], "x")[0], 0.01);
  EXPECT_GT(numbers(whole[2], "x")[1], 100);
  // Powers of ten are marked although the axis begins between two.
  const std::vector<std::string> marks = whole[2]["marks"][1];
  EXPECT_THAT(marks, testing::IsSupersetOf({"1e-4", "1e-3", "0.01", "0.1", "1"}));
  EXPECT_THAT(marks, testing::Each(testing::SizeIs(testing::Le(4))));
  const auto metre = numbers(whole[3], "metre");
  EXPECT_NEAR(metre[0] / metre[1], 1, 0.01);  // the track is to scale

  const auto zoomed = numbers(seen["zoomed"][0], "x");
  EXPECT_NEAR(zoomed[0], 25, 1.5);
  EXPECT_NEAR(zoomed[1], 75, 1.5);
  EXPECT_EQ(seen["zoomed"][1]["x"], seen["zoomed"][0]["x"]);  // the same times
  EXPECT_EQ(seen["zoomed"][3]["x"], whole[3]["x"]);
  EXPECT_THAT(seen["pointed"][0]["legend"].get<std::string>(), HasSubstr("value 5"));
  EXPECT_EQ(seen["again"][0]["x"], whole[0]["x"]);
  EXPECT_EQ(seen["again"][1]["x"], whole[1]["x"]);
  const auto closer = numbers(seen["closer"][3], "metre");
  EXPECT_NEAR(closer[0] / metre[0], 2, 0.02);
  EXPECT_NEAR(closer[1] / metre[1], 2, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Looks, ReportPage,
                         testing::Values(Look{1280, "light"}, Look{1280, "dark"},
                                         Look{390, "light"}, Look{390, "dark"}),
                         [](const auto& look) {
                           return std::string(look.param.theme) + std::to_string(look.param.width);
                         });

TEST(ReportPages, WithoutPlotsHaveNoScript) {
  const auto page = drydock::report::html::page("words", "<p>one</p>");
  EXPECT_EQ(page.find("<script"), std::string::npos);
  EXPECT_EQ(page.find("http"), std::string::npos);
}

TEST(ReportPages, APlotOfAQuantityThatIsNotGivenIsLeftOut) {
  EXPECT_EQ(drydock::report::html::figure(line("none", {0, 1}, {NAN, NAN})), "");
}

}  // namespace page_test
