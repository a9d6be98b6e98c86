#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

namespace drydock::motion {

/// A cubic spline through values at knots: twice continuously differentiable, with ends that are
/// "not a knot". So its value is right within h^4 of a smooth function, its rate within h^3, its
/// acceleration within h^2, up to the ends (de Boor, A Practical Guide to Splines, chapter IV).
template <int N>
class CubicSpline {
 public:
  using Value = Eigen::Matrix<double, N, 1>;
  struct Point {
    Value value, rate, acceleration;
  };

  /// Two knots at least, their times rising, s; a value for each. Two make a line, three a
  /// parabola.
  CubicSpline(std::vector<double> knots, std::vector<Value> values)
      : knots_(std::move(knots)), values_(std::move(values)), curvature_(curvature()) {}

  /// Beyond the ends the outer cubics go on.
  Point at(double t) const {
    const auto next = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, t);
    const auto i = static_cast<std::size_t>(next - knots_.begin()) - 1;
    const double h = step(i), a = (knots_[i + 1] - t) / h, b = 1 - a;
    const Value &y0 = values_[i], &y1 = values_[i + 1];
    const Value &m0 = curvature_[i], &m1 = curvature_[i + 1];
    return {a * y0 + b * y1 + (h * h / 6) * (a * (a * a - 1) * m0 + b * (b * b - 1) * m1),
            (y1 - y0) / h + (h / 6) * ((1 - 3 * a * a) * m0 + (3 * b * b - 1) * m1),
            a * m0 + b * m1};
  }

 private:
  double step(std::size_t i) const { return knots_[i + 1] - knots_[i]; }
  Value slope(std::size_t i) const { return (values_[i + 1] - values_[i]) / step(i); }

  /// The second derivative at each knot. Inside the rates of both sides agree, which is a
  /// tridiagonal system; the outer two are eliminated first: the third derivative does not jump at
  /// the knots next to the ends.
  std::vector<Value> curvature() const {
    const std::size_t n = knots_.size();
    std::vector<Value> m(n, Value::Zero());
    if (n < 3) return m;
    if (n == 3) {
      m.assign(n, 2 * (slope(1) - slope(0)) / (step(0) + step(1)));
      return m;
    }
    std::vector<double> upper(n, 0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const double before = step(i - 1), behind = step(i);
      double lower = before, diagonal = 2 * (before + behind);
      upper[i] = behind;
      if (i == 1) {
        lower = 0;
        diagonal += before * (1 + before / behind);
        upper[i] -= before * before / behind;
      }
      if (i + 2 == n) {
        diagonal += behind * (1 + behind / before);
        lower -= behind * behind / before;
        upper[i] = 0;
      }
      const double pivot = diagonal - lower * upper[i - 1];
      upper[i] /= pivot;
      m[i] = (6 * (slope(i) - slope(i - 1)) - lower * m[i - 1]) / pivot;
    }
    for (std::size_t i = n - 2; i-- > 1;) m[i] -= upper[i] * m[i + 1];
    m[0] = m[1] + (m[1] - m[2]) * (step(0) / step(1));
    m[n - 1] = m[n - 2] + (m[n - 2] - m[n - 3]) * (step(n - 2) / step(n - 3));
    return m;
  }

  std::vector<double> knots_;
  std::vector<Value> values_;
  std::vector<Value> curvature_;
};

}  // namespace drydock::motion
