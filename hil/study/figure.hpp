#pragma once

#include <string>
#include <vector>

namespace drydock::study {

/// One curve: equal numbers of x and y.
struct Curve {
  std::string label;
  std::vector<double> x, y;
  bool band = false;  ///< drawn as +-y around zero (a sigma band)
};

struct Figure {
  std::string title, x_label, y_label;
  std::vector<Curve> curves;
  double y_limit = 0;  ///< 0: as the data needs; else as far as this, down only where they go
  bool equal_scales = false;  ///< a metre is as long on both axes
  bool log_y = false;         ///< a decade is as high everywhere; values are above 0
};

}  // namespace drydock::study
