#pragma once

#include <array>
#include <cstdint>

namespace drydock::consistency {

/// How a residual went since its fault began.
enum class Shape : std::uint8_t { step, ramp, parabola, delayed, scaled };

/// Generalised likelihood ratio of the shapes: for residuals r = a s(t) + white noise with unknown
/// a the best a explains (sum r s)^2 / (sum s s) of the squares. A ramp is found late, when it is
/// already as high as the noise: a residual that grows by more than 0.6 of its mean along a fitted
/// straight line counts as one.
class ShapeTest {
 public:
  void clear() { *this = {}; }

  /// `since_s`: time since the fault began. `rate` and `value`: derivative and value of the
  /// measured quantity, less their means (a constant cannot be told from a step).
  void take(double residual, double since_s, double rate, double value);

  /// A step, while there are too few residuals to tell.
  Shape best() const;
  bool grows() const;

  /// The share of the squares that the best shape explains.
  double fit() const;
  /// What the best of a step and a ramp leaves of the squares.
  double left_over() const;

  /// The best a of one shape.
  double amount(Shape shape) const;

 private:
  struct Sums {
    double rs = 0, ss = 0;
    double explained() const { return ss > 0 ? rs * rs / ss : 0; }
  };
  std::array<Sums, 5> sums_{};
  double all_ = 0, time_ = 0, latest_s_ = 0;
  int count_ = 0;
};

}  // namespace drydock::consistency
