#pragma once

#include <vector>

namespace drydock::campaign {

/// A sum without any rounding error until it is read: parts that do not overlap, whose sum is
/// exact (Shewchuk, Adaptive Precision Floating-Point Arithmetic, 1997). So the order in which
/// numbers and other sums are added does not matter, to the last bit. Numbers must be finite.
class ExactSum {
 public:
  void add(double x);
  void add_product(double x, double y);  ///< x times y without rounding; |x y| within 1e-290, 1e300
  void add(const ExactSum& other);
  void subtract_product(const ExactSum& a, const ExactSum& b);  ///< a times b

  double rounded() const;  ///< the nearest double
  const std::vector<double>& parts() const { return parts_; }

 private:
  std::vector<double> parts_;  // growing magnitude
};

}  // namespace drydock::campaign
