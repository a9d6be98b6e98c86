#include "estimators/consistency/shape.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::consistency {
namespace {

/// A rarer shape must explain so much more of what a step or a ramp leaves over.
constexpr double rarer_share = 0.4;
constexpr int enough_to_tell = 10;
constexpr double growing_share = 0.6;

}  // namespace

void ShapeTest::take(double residual, double since_s, double rate, double value) {
  const std::array shapes{1.0, since_s, since_s * since_s, rate, value};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    sums_[i].rs += residual * shapes[i];
    sums_[i].ss += shapes[i] * shapes[i];
  }
  all_ += residual * residual;
  time_ += since_s;
  latest_s_ = since_s;
  ++count_;
}

double ShapeTest::fit() const {
  return all_ > 0 ? sums_[static_cast<std::size_t>(best())].explained() / all_ : 0;
}

double ShapeTest::amount(Shape shape) const {
  const Sums& sums = sums_[static_cast<std::size_t>(shape)];
  return sums.ss > 0 ? sums.rs / sums.ss : 0;
}

/// The line of least squares through the residuals.
bool ShapeTest::grows() const {
  const double n = count_, mean = sums_[0].rs / n, middle = time_ / n;
  const double spread = sums_[1].ss - n * middle * middle;
  if (spread <= 0) return false;
  const double slope = (sums_[1].rs - n * mean * middle) / spread;
  return slope * mean > 0 && std::abs(slope) * latest_s_ > growing_share * std::abs(mean);
}

double ShapeTest::left_over() const { return all_ - sums_[grows() ? 1 : 0].explained(); }

Shape ShapeTest::best() const {
  if (count_ < enough_to_tell) return Shape::step;
  std::size_t best = grows() ? 1 : 0;
  const double left = left_over();
  for (std::size_t i = best == 1 ? 2 : 3; i < sums_.size(); ++i)
    if (all_ - sums_[i].explained() < rarer_share * left &&
        sums_[i].explained() > sums_[best].explained())
      best = i;
  return static_cast<Shape>(best);
}

}  // namespace drydock::consistency
