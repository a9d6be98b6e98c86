#pragma once

#include <optional>

namespace drydock::device {

/// The water above a pressure sensor: of one density under standard gravity,
///   depth = (p - p_surface) / (density g),  g = 9.80665 m/s2,
/// or, where a latitude is given, of standard ocean water (salinity 35, 0 deg C) as in EOS-80.
struct WaterColumn {
  double surface_pressure_pa = 101'325;
  double density_kgm3 = 1025;
  std::optional<double> unesco_latitude_rad;

  double depth_m(double pressure_pa) const;
};

/// Depth of a sea pressure (above the surface's) and its inverse. N. P. Fofonoff and R. C. Millard,
/// Algorithms for computation of fundamental properties of seawater, UNESCO Technical Papers in
/// Marine Science 44 (1983), after Saunders and Fofonoff (1976): within 0.1 m of the integral of
/// the equation of state, to 10 000 dbar. Above the surface depth and pressure are negative.
double unesco_depth_m(double sea_pressure_pa, double latitude_rad);
double unesco_pressure_pa(double depth_m, double latitude_rad);

}  // namespace drydock::device
