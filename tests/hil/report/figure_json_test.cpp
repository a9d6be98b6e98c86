#include "hil/report/figure_json.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace figure_json_test {

using drydock::report::Figure;
using drydock::report::to_json;
using nlohmann::json;

TEST(FigureJson, HasThePointsToSevenDigitsAndNullForWhatIsNoNumber) {
  Figure figure{"track", "east [m]", "north [m]", {}};
  figure.curves.push_back(
      {"truth", {0, 1234567.8, 0.1}, {-1e-9, std::numeric_limits<double>::quiet_NaN(), 3}});
  figure.shades = {{2, 4.5}};
  figure.y_down = figure.equal_scales = true;
  const auto read = json::parse(to_json(figure));
  EXPECT_EQ(read["curves"][0]["x"], json({0, 1234568, 0.1}));
  EXPECT_EQ(read["curves"][0]["y"], json({-1e-9, nullptr, 3}));
  EXPECT_EQ(read["shades"], json::parse("[[2, 4.5]]"));
  EXPECT_EQ(read["y_down"], true);
  EXPECT_EQ(read["equal_scales"], true);
  EXPECT_EQ(read["log_y"], false);
  EXPECT_EQ(read["x_label"], "east [m]");
}

TEST(FigureJson, OfALabelNothingIsRunAndNothingEndsTheScript) {
  Figure figure{"", "time [s]", "</script><b>", {}};
  figure.curves.push_back({"a \"quote\", a \xFF byte", {}, {}});
  const auto text = to_json(figure);
  EXPECT_EQ(text.find('<'), std::string::npos);
  const auto read = json::parse(text);
  EXPECT_EQ(read["y_label"], "</script><b>");
  EXPECT_EQ(read["curves"][0]["label"], "a \"quote\", a \xEF\xBF\xBD byte");
}

}  // namespace figure_json_test
