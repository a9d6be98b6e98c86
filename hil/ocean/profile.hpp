#pragma once

#include <vector>

namespace drydock::ocean {

/// A quantity over depth: cubic between knots, constant above the first and below the last. The
/// first derivative is continuous everywhere, and between two knots the value never leaves the
/// range of their values (Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5 (1984)). Without knots
/// it is 0.
class Profile {
 public:
  struct Knot {
    double depth_m = 0, value = 0;
  };

  Profile() = default;
  explicit Profile(std::vector<Knot> knots);  ///< ordered by depth; no two depths are equal

  double value(double depth_m) const;
  double slope(double depth_m) const;     ///< per metre
  double integral(double depth_m) const;  ///< from the surface, closed form

 private:
  struct Piece {
    double depth_m = 0, value = 0, slope = 0;
    double from_first = 0;  ///< integral from the first knot
  };
  double integral_from_first(double depth_m) const;
  /// The piece whose knot is the last one above `depth_m`. Only between the first and the last
  /// knot.
  const Piece* above(double depth_m) const;

  std::vector<Piece> pieces_;
};

}  // namespace drydock::ocean
