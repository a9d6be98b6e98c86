#include "hil/ocean/ocean.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "drivers/measurement/sound_speed.hpp"
#include "drivers/measurement/units.hpp"
#include "drivers/measurement/water_column.hpp"
#include "estimators/frame/attitude.hpp"
#include "estimators/frame/earth.hpp"

namespace drydock::ocean {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using rig_config::BedKind;
using rig_config::WaterKind;

Profile component(const std::vector<rig_config::CurrentConfig>& current, std::size_t axis) {
  std::vector<Profile::Knot> knots;
  knots.reserve(current.size());
  for (const auto& knot : current) knots.push_back({knot.depth_m, knot.velocity_ned_mps[axis]});
  return Profile(std::move(knots));
}

Profile density_profile(const rig_config::WaterConfig& water) {
  if (water.kind == WaterKind::uniform) return Profile({{0, water.density_kgm3}});
  std::vector<Profile::Knot> knots;
  knots.reserve(water.density.size());
  for (const auto& knot : water.density) knots.push_back({knot.depth_m, knot.density_kgm3});
  return Profile(std::move(knots));
}

Vector2d scale(double latitude_rad) {
  return {frame::meridian_radius(latitude_rad),
          frame::transverse_radius(latitude_rad) * std::cos(latitude_rad)};
}

Raster depths_of(const rig_config::BedConfig& config) {
  auto raster = read_raster_file(config.file);
  if (!raster) {
    const auto& [line, what] = raster.error();
    throw BadRaster(line > 0 ? fmt::format("{}:{}: {}", config.file, line, what)
                             : fmt::format("{}: {}", config.file, what));
  }
  if (config.elevations)
    for (float& value : raster->values) value = -value;
  return std::move(*raster);
}

}  // namespace

Ocean::Ocean(const rig_config::OceanConfig& config, const frame::Position& origin)
    : origin_(origin),
      metres_per_rad_(scale(origin.latitude_rad)),
      bed_(make_bed(config.bed)),
      current_{component(config.current, 0), component(config.current, 1),
               component(config.current, 2)},
      tide_(config.tide),
      water_(config.water),
      density_(density_profile(config.water)) {}

Bed Ocean::make_bed(const rig_config::BedConfig& config) const {
  if (config.kind != BedKind::raster) {
    const double gradient = config.kind == BedKind::slope ? config.gradient : 0;
    return PlaneBed{config.depth_m, gradient * Vector2d{std::cos(config.downhill_rad),
                                                        std::sin(config.downhill_rad)}};
  }
  Raster raster = depths_of(config);
  const Vector2d corner{raster.y, raster.x};
  if (config.in_metres) {
    const double spacing = raster.spacing;
    return RasterBed(std::move(raster), corner, {spacing, spacing});
  }
  const Vector2d spacing = raster.spacing * units::degree * metres_per_rad_;
  // Longitudes of a raster may exceed 180 deg. Its middle is taken as the equivalent longitude
  // nearest to the origin.
  const double half = static_cast<double>(raster.columns - 1) / 2 * raster.spacing * units::degree;
  const double middle = frame::wrap_pi(corner.y() * units::degree + half - origin_.longitude_rad);
  const Vector2d south_west{
      (corner.x() * units::degree - origin_.latitude_rad) * metres_per_rad_.x(),
      (middle - half) * metres_per_rad_.y()};
  return RasterBed(std::move(raster), south_west, spacing);
}

Vector2d Ocean::chart(double latitude_rad, double longitude_rad) const {
  return {(latitude_rad - origin_.latitude_rad) * metres_per_rad_.x(),
          frame::wrap_pi(longitude_rad - origin_.longitude_rad) * metres_per_rad_.y()};
}

Vector3d Ocean::tide_ned(double t_s) const {
  if (!tide_) return Vector3d::Zero();
  const double rate = 2 * std::numbers::pi / tide_->period_s;
  return std::sin(rate * t_s + tide_->phase_rad) *
         Eigen::Map<const Vector3d>(tide_->velocity_ned_mps.data());
}

Vector3d Ocean::current_ned(double depth_m, double t_s) const {
  const Vector3d layer{current_[0].value(depth_m), current_[1].value(depth_m),
                       current_[2].value(depth_m)};
  return layer + tide_ned(t_s);
}

Vector3d Ocean::mean_current_ned(double from_m, double to_m, double t_s) const {
  const double height = to_m - from_m;
  if (std::abs(height) < 1e-6) return current_ned(from_m, t_s);
  const auto mean = [&](const Profile& p) {
    return (p.integral(to_m) - p.integral(from_m)) / height;
  };
  return Vector3d{mean(current_[0]), mean(current_[1]), mean(current_[2])} + tide_ned(t_s);
}

Vector3d Ocean::current_rate_ned(double depth_m, double descent_mps, double t_s) const {
  Vector3d rate = descent_mps * Vector3d{current_[0].slope(depth_m), current_[1].slope(depth_m),
                                         current_[2].slope(depth_m)};
  if (tide_) {
    const double w = 2 * std::numbers::pi / tide_->period_s;
    rate += w * std::cos(w * t_s + tide_->phase_rad) *
            Eigen::Map<const Vector3d>(tide_->velocity_ned_mps.data());
  }
  return rate;
}

double Ocean::bed_depth_m(double latitude_rad, double longitude_rad) const {
  return depth_at(bed_, chart(latitude_rad, longitude_rad));
}

std::optional<double> Ocean::bed_range_m(const frame::Position& from, const Vector3d& direction_ned,
                                         double longest_m) const {
  const Vector2d place = chart(from.latitude_rad, from.longitude_rad);
  const Vector2d stretch = metres_per_rad_.array() / scale(from.latitude_rad).array();
  return range(
      bed_,
      {{place.x(), place.y(), -from.height_m},
       {stretch.x() * direction_ned.x(), stretch.y() * direction_ned.y(), direction_ned.z()}},
      longest_m);
}

double Ocean::density_kgm3(double depth_m) const {
  if (water_.kind != WaterKind::standard) return density_.value(depth_m);
  namespace standard = measurement::ocean;
  const double dbar =
      measurement::unesco_pressure_pa(std::max(depth_m, 0.0), origin_.latitude_rad) /
      standard::decibar_pa;
  return standard::decibar_pa / standard::volume_slope(dbar);
}

double Ocean::pressure_pa(double depth_m, double latitude_rad) const {
  const double under = std::max(depth_m, 0.0);
  return water_.surface_pressure_pa +
         (water_.kind == WaterKind::standard
              ? measurement::unesco_pressure_pa(under, latitude_rad)
              : frame::gravity(latitude_rad) * density_.integral(under));
}

double Ocean::sound_speed_mps(double depth_m) const {
  return measurement::medwin_mps(water_.temperature_k - measurement::melting_point_k,
                                 water_.salinity_ppt, depth_m);
}

}  // namespace drydock::ocean
