#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <variant>

#include "hil/ocean/raster.hpp"

/// Sea beds on a chart: metres north and east of the start of the mission.
namespace drydock::ocean {

/// A straight line into the water: its first point (north, east, depth) and the change per metre
/// along it.
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

/// A raster with bilinear interpolation. Outside the raster the bed has the depth of the nearest
/// edge point.
class RasterBed {
 public:
  /// Columns go east and rows go north. `south_west` is the chart place of the first point;
  /// `spacing` is the distance of two points in metres north and east.
  RasterBed(Raster raster, const Eigen::Vector2d& south_west, const Eigen::Vector2d& spacing);

  double depth_at(const Eigen::Vector2d& place) const;
  /// Goes cell by cell. Within a cell the bed along a straight line is a parabola.
  std::optional<double> range(const Ray& ray, double longest_m) const;

 private:
  double in_rows_and_columns(const Eigen::Array2d& at) const;

  std::shared_ptr<const Raster> raster_;  ///< values are depths
  Eigen::Array2d south_west_, spacing_;
};

using Bed = std::variant<PlaneBed, RasterBed>;

double depth_at(const Bed& bed, const Eigen::Vector2d& place);

/// Distance along the ray to the point where it meets the bed from above. Empty if there is none
/// within `longest_m`, or if the ray begins in the bed.
std::optional<double> range(const Bed& bed, const Ray& ray, double longest_m);

}  // namespace drydock::ocean
