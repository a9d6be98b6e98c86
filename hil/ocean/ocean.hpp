#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "estimators/frame/geodetic.hpp"
#include "hil/ocean/bed.hpp"
#include "hil/ocean/profile.hpp"
#include "rig_config/ocean.hpp"

namespace drydock::ocean {

/// The water of a mission and the bed under it. docs/world/ocean.md numbers the equations. Depths
/// are below the ellipsoid, which is the sea surface. Times count from the mission's start.
class Ocean {
 public:
  /// `origin`: start of the mission. Throws BadRaster if a raster cannot be read.
  Ocean(const rig_config::OceanConfig& config, const frame::Position& origin);

  /// Velocity of the water over ground, m/s.
  Eigen::Vector3d current_ned(double depth_m, double t_s) const;
  /// Mean of the current between two depths, m/s.
  Eigen::Vector3d mean_current_ned(double from_m, double to_m, double t_s) const;
  /// Rate of change of the current for a body that sinks at `descent_mps`, m/s2.
  Eigen::Vector3d current_rate_ned(double depth_m, double descent_mps, double t_s) const;

  double bed_depth_m(double latitude_rad, double longitude_rad) const;
  /// Distance from a place along a unit vector to the bed. Empty if there is none within
  /// `longest_m`.
  std::optional<double> bed_range_m(const frame::Position& from,
                                    const Eigen::Vector3d& direction_ned, double longest_m) const;

  double density_kgm3(double depth_m) const;
  /// Absolute pressure, Pa. Above the surface it is the air pressure.
  double pressure_pa(double depth_m, double latitude_rad) const;
  double surface_pressure_pa() const { return water_.surface_pressure_pa; }
  double temperature_k() const { return water_.temperature_k; }
  double salinity_ppt() const { return water_.salinity_ppt; }
  double sound_speed_mps(double depth_m) const;

 private:
  Eigen::Vector3d tide_ned(double t_s) const;
  Eigen::Vector2d chart(double latitude_rad, double longitude_rad) const;
  Bed make_bed(const rig_config::BedConfig& config) const;

  frame::Position origin_;
  Eigen::Vector2d metres_per_rad_;  ///< north, east, at the origin
  Bed bed_;
  std::array<Profile, 3> current_;
  std::optional<rig_config::TideConfig> tide_;
  rig_config::WaterConfig water_;
  Profile density_;
};

}  // namespace drydock::ocean
