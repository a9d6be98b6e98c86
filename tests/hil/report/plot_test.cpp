#include "hil/report/plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace plot_test {

using drydock::report::Figure;
using drydock::report::render_svg;
using testing::HasSubstr;

class Gnuplot : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v gnuplot >/dev/null") != 0)
      GTEST_SKIP() << "gnuplot is not installed";
    plot_.title = "line";
    plot_.curves.push_back({"curve", {0, 10}, {0, 1}});
  }
  Figure plot_;
};

TEST_F(Gnuplot, ANameIsWrittenAsItIsAndNothingOfItIsRun) {
  plot_.title = "rig_config/a^2 `echo ran` {b}";
  plot_.curves[0].label = "imu_1";
  const auto svg = render_svg(plot_);
  EXPECT_THAT(svg, HasSubstr("rig_config/a^2 `echo ran` {b}"));
  EXPECT_THAT(svg, HasSubstr(">imu_1<"));
}

TEST_F(Gnuplot, OnEqualScalesAFlatTrackIsAFlatPicture) {
  plot_.equal_scales = true;
  const auto flat = render_svg(plot_);
  EXPECT_THAT(flat, HasSubstr("viewBox=\"0 0 860 240\""));
  plot_.curves[0].y = {0, 10};
  EXPECT_THAT(render_svg(plot_), HasSubstr("viewBox=\"0 0 860 600\""));
}

/// The y of the curve's first and last point, in the picture's pixels: they grow downwards.
std::pair<double, double> ends_of_curve(const std::string& svg) {
  const auto path = svg.find("d='M", svg.find("rgb(  0, 114, 178)'", svg.find("gnuplot_plot_1")));
  const auto end = svg.find('\'', path + 4), begin = svg.rfind('M', end);
  return {std::stod(svg.substr(svg.find(',', begin) + 1)),
          std::stod(svg.substr(svg.rfind(',', end) + 1))};
}

TEST_F(Gnuplot, AGrowingValueRisesAndAGrowingDepthSinks) {
  const auto [from, to] = ends_of_curve(render_svg(plot_));
  EXPECT_GT(from, to);
  plot_.y_down = true;
  const auto [shallow, deep] = ends_of_curve(render_svg(plot_));
  EXPECT_LT(shallow, deep);
}

TEST_F(Gnuplot, AnApostropheStaysWhereItWas) {
  plot_.title = "the filter's band";
  EXPECT_THAT(render_svg(plot_), HasSubstr("the filter's band"));
}

}  // namespace plot_test
