#pragma once

#include <string>
#include <vector>

namespace drydock::report {

/// One curve: equal numbers of x and y.
struct Curve {
  std::string label;
  std::vector<double> x, y;
  bool band = false;    ///< drawn as +-y around zero (a sigma band)
  bool points = false;  ///< separate points, not joined
};

/// A stretch of the x axis in which something was wrong.
struct Shade {
  double from = 0, to = 0;
};

struct Figure {
  std::string title, x_label, y_label;
  std::vector<Curve> curves;
  double y_limit = 0;  ///< 0: automatic; else the axis ends here, and at -y_limit if a value is
                       ///< negative
  bool equal_scales = false;          ///< a metre has the same length on both axes
  bool log_x = false, log_y = false;  ///< values must be positive
  std::vector<Shade> shades{};        ///< drawn behind the curves
  bool y_down = false;                ///< y grows downwards, as depth does
};

}  // namespace drydock::report
