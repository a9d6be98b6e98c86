#include "hil/ocean/profile.hpp"

#include <algorithm>

namespace drydock::ocean {
namespace {

/// docs/world/ocean.md (5): Brodlie's weighted harmonic mean; 0 at an extremum.
double slope_at_knot(double width_above, double secant_above, double width_below,
                     double secant_below) {
  if (secant_above * secant_below <= 0) return 0;
  const double weight = (width_above + 2 * width_below) / (3 * (width_above + width_below));
  return secant_above * secant_below / (weight * secant_below + (1 - weight) * secant_above);
}

}  // namespace

Profile::Profile(std::vector<Knot> knots) {
  const auto width = [&](std::size_t i) { return knots[i + 1].depth_m - knots[i].depth_m; };
  const auto secant = [&](std::size_t i) {
    return (knots[i + 1].value - knots[i].value) / width(i);
  };
  for (std::size_t i = 0; i < knots.size(); ++i) {
    Piece piece{knots[i].depth_m, knots[i].value, 0, 0};
    if (i > 0 && i + 1 < knots.size())
      piece.slope = slope_at_knot(width(i - 1), secant(i - 1), width(i), secant(i));
    if (i > 0) {
      const Piece& before = pieces_.back();
      const double h = width(i - 1);
      piece.from_first = before.from_first + h * (before.value + piece.value) / 2 +
                         h * h * (before.slope - piece.slope) / 12;
    }
    pieces_.push_back(piece);
  }
}

const Profile::Piece* Profile::above(double depth_m) const {
  const auto below = std::ranges::upper_bound(pieces_, depth_m, {}, &Piece::depth_m);
  return &*std::prev(below);
}

double Profile::value(double depth_m) const {
  if (pieces_.empty()) return 0;
  if (depth_m <= pieces_.front().depth_m) return pieces_.front().value;
  if (depth_m >= pieces_.back().depth_m) return pieces_.back().value;
  const Piece* a = above(depth_m);
  const Piece* b = a + 1;
  const double h = b->depth_m - a->depth_m, x = (depth_m - a->depth_m) / h, y = 1 - x;
  return y * y * ((1 + 2 * x) * a->value + x * h * a->slope) +
         x * x * ((1 + 2 * y) * b->value - y * h * b->slope);
}

double Profile::slope(double depth_m) const {
  if (pieces_.empty() || depth_m <= pieces_.front().depth_m || depth_m >= pieces_.back().depth_m)
    return 0;
  const Piece* a = above(depth_m);
  const Piece* b = a + 1;
  const double h = b->depth_m - a->depth_m, x = (depth_m - a->depth_m) / h;
  return 6 * x * (1 - x) * (b->value - a->value) / h + (1 - x) * (1 - 3 * x) * a->slope +
         x * (3 * x - 2) * b->slope;
}

double Profile::integral(double depth_m) const {
  return pieces_.empty() ? 0 : integral_from_first(depth_m) - integral_from_first(0);
}

double Profile::integral_from_first(double depth_m) const {
  const Piece& first = pieces_.front();
  const Piece& last = pieces_.back();
  if (depth_m <= first.depth_m) return (depth_m - first.depth_m) * first.value;
  if (depth_m >= last.depth_m) return last.from_first + (depth_m - last.depth_m) * last.value;
  const Piece* a = above(depth_m);
  const Piece* b = a + 1;
  const double h = b->depth_m - a->depth_m, x = (depth_m - a->depth_m) / h;
  const double x2 = x * x, x3 = x2 * x, x4 = x2 * x2;
  return a->from_first + h * ((x - x3 + x4 / 2) * a->value + (x3 - x4 / 2) * b->value) +
         h * h * ((x2 / 2 - 2 * x3 / 3 + x4 / 4) * a->slope + (x4 / 4 - x3 / 3) * b->slope);
}

}  // namespace drydock::ocean
