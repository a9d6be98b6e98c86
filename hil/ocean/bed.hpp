#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <variant>

#include "hil/ocean/raster.hpp"

/// Sea beds on a chart: metres north and east of the place where the mission begins.
namespace drydock::ocean {

/// A straight line into the water: north, east, depth where it begins, and what each metre along
/// it adds.
struct Ray {
  Eigen::Vector3d from, along;
};

/// depth = depth_m + gradient . (north, east)
struct PlaneBed {
  double depth_m = 0;
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();

  double depth_at(const Eigen::Vector2d& place) const { return depth_m + gradient.dot(place); }
  std::optional<double> range(const Ray& ray, double longest_m) const;
};

/// A raster, bilinear between its points. Beyond its edge the bed keeps the depth of the edge's
/// nearest point.
class RasterBed {
 public:
  /// Columns go east and rows north; `south_west` is the chart place of the first point of both,
  /// `spacing` the metres north and east from point to point.
  RasterBed(Raster raster, Eigen::Vector2d south_west, Eigen::Vector2d spacing);

  double depth_at(const Eigen::Vector2d& place) const;
  /// Cell by cell; within each the bed under a straight line is a parabola.
  std::optional<double> range(const Ray& ray, double longest_m) const;

 private:
  double in_rows_and_columns(const Eigen::Array2d& at) const;

  std::shared_ptr<const Raster> raster_;  ///< values are depths
  Eigen::Array2d south_west_, spacing_;
};

using Bed = std::variant<PlaneBed, RasterBed>;

double depth_at(const Bed& bed, const Eigen::Vector2d& place);

/// How far along the ray it meets the bed from above; empty: not within `longest_m`, or it begins
/// in the bed.
std::optional<double> range(const Bed& bed, const Ray& ray, double longest_m);

}  // namespace drydock::ocean
