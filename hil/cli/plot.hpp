#pragma once

#include <string>
#include <vector>

namespace drydock::cli {

/// One curve: equal numbers of x and y.
struct Series {
  std::string label;
  std::vector<double> x, y;
  bool band = false;  ///< drawn as +-y around zero (a sigma band)
};

struct Plot {
  std::string title, x_label, y_label;
  std::vector<Series> series;
};

/// The plot as an SVG element, drawn by gnuplot. Empty when gnuplot is not there or fails.
std::string render_svg(const Plot& plot);

}  // namespace drydock::cli
