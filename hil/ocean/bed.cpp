#include "hil/ocean/bed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace drydock::ocean {
namespace {

using Eigen::Array2d;
using Eigen::Vector2d;

/// First zero in (0, 1] of the parabola through (0, y0), (1/2, y1), (1, y2) with y0 < 0. This form
/// gives the first of both zeros, whichever way the parabola opens.
std::optional<double> first_rise_through_zero(double y0, double y1, double y2) {
  const double curvature = 2 * (y0 + y2 - 2 * y1), slope = 4 * y1 - 3 * y0 - y2;
  const double discriminant = slope * slope - 4 * curvature * y0;
  if (discriminant < 0) return std::nullopt;
  const double denominator = slope + std::sqrt(discriminant);
  if (denominator <= 0 || -2 * y0 > denominator) return std::nullopt;
  return -2 * y0 / denominator;
}

/// The grid lines that a ray crosses along one axis, in order.
class Crossings {
 public:
  Crossings(double from, double step, double last) : from_(from), step_(step), last_(last) {
    line_ = step > 0 ? std::max(std::floor(from) + 1, 0.0) : std::min(std::ceil(from) - 1, last);
  }
  /// Distance along the ray to the next grid line; infinite after the last.
  double next() const {
    const bool none = step_ == 0 || line_ < 0 || line_ > last_;
    return none ? HUGE_VAL : (line_ - from_) / step_;
  }
  void pass() { line_ += step_ > 0 ? 1 : -1; }

 private:
  double from_, step_, last_, line_;
};

}  // namespace

std::optional<double> PlaneBed::range(const Ray& ray, double longest_m) const {
  const double above = depth_at(ray.from.head<2>()) - ray.from.z();
  const double approach = ray.along.z() - gradient.dot(ray.along.head<2>());
  if (above <= 0 || above > approach * longest_m) return std::nullopt;
  return above / approach;
}

RasterBed::RasterBed(Raster raster, const Vector2d& south_west, const Vector2d& spacing)
    : raster_(std::make_shared<const Raster>(std::move(raster))),
      south_west_(south_west),
      spacing_(spacing) {}

double RasterBed::depth_at(const Vector2d& place) const {
  return in_rows_and_columns((place.array() - south_west_) / spacing_);
}

double RasterBed::in_rows_and_columns(const Array2d& at) const {
  const Array2d last(static_cast<double>(raster_->rows - 1),
                     static_cast<double>(raster_->columns - 1));
  const Array2d inside = at.max(0).min(last);
  const Array2d corner = inside.floor().min((last - 1).max(0));
  const Array2d x = inside - corner;
  const auto row = static_cast<std::size_t>(corner[0]),
             column = static_cast<std::size_t>(corner[1]);
  const std::size_t north = std::min(row + 1, raster_->rows - 1);
  const std::size_t east = std::min(column + 1, raster_->columns - 1);
  const auto between = [&](std::size_t r) {
    return (1 - x[1]) * raster_->at(r, column) + x[1] * raster_->at(r, east);
  };
  return (1 - x[0]) * between(row) + x[0] * between(north);
}

std::optional<double> RasterBed::range(const Ray& ray, double longest_m) const {
  const Array2d from = (ray.from.head<2>().array() - south_west_) / spacing_;
  const Array2d step = ray.along.head<2>().array() / spacing_;
  const auto below_bed = [&](double s) {
    return ray.from.z() + s * ray.along.z() - in_rows_and_columns(from + s * step);
  };
  std::array crossings{Crossings(from[0], step[0], static_cast<double>(raster_->rows - 1)),
                       Crossings(from[1], step[1], static_cast<double>(raster_->columns - 1))};
  double s = 0, here = below_bed(0);
  if (here >= 0) return std::nullopt;
  while (s < longest_m) {
    auto& nearest = crossings[crossings[0].next() < crossings[1].next() ? 0 : 1];
    const double end = std::min(nearest.next(), longest_m);
    nearest.pass();
    const double there = below_bed(end);
    if (const auto x = first_rise_through_zero(here, below_bed((s + end) / 2), there))
      return s + *x * (end - s);
    s = end;
    here = std::min(there, -std::numeric_limits<double>::min());  // rounding may hide a root
  }
  return std::nullopt;
}

double depth_at(const Bed& bed, const Vector2d& place) {
  return std::visit([&](const auto& kind) { return kind.depth_at(place); }, bed);
}

std::optional<double> range(const Bed& bed, const Ray& ray, double longest_m) {
  return std::visit([&](const auto& kind) { return kind.range(ray, longest_m); }, bed);
}

}  // namespace drydock::ocean
