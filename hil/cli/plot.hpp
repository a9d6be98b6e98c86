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
  double y_limit = 0;         ///< 0: as the data needs; else the axis goes from -y_limit to y_limit
  bool equal_scales = false;  ///< a metre is as long on both axes
  bool logarithmic = false;   ///< both axes; what is not above zero is left out
};

/// The plot as an SVG element, drawn by gnuplot. Empty when gnuplot is not there or fails.
std::string render_svg(const Plot& plot);

}  // namespace drydock::cli
