#pragma once

#include <cmath>
#include <optional>

#include "drivers/measurement/units.hpp"

namespace drydock::measurement {
namespace ocean {

inline constexpr double decibar_pa = 1e4;

/// Gravity at the surface, m/s2 (Anon. 1970, as the report cites it).
inline double surface_gravity(double latitude_rad) {
  const double x = std::sin(latitude_rad) * std::sin(latitude_rad);
  return 9.780318 * (1 + (5.2788e-3 + 2.36e-5 * x) * x);
}

inline constexpr double gravity_per_decibar =
    1.092e-6;  // half the increase with depth: the mean of the column

/// Integral of the specific volume of the standard ocean over pressure, m2/s2, and its derivative.
inline double volume_integral(double p) {
  return (((-1.82e-15 * p + 2.279e-10) * p - 2.2512e-5) * p + 9.72659) * p;
}
inline double volume_slope(double p) {
  return ((-4 * 1.82e-15 * p + 3 * 2.279e-10) * p - 2 * 2.2512e-5) * p + 9.72659;
}

}  // namespace ocean

/// Depth from sea pressure (relative to the surface) and its inverse. N. P. Fofonoff and R. C.
/// Millard, Algorithms for computation of fundamental properties of seawater, UNESCO Technical
/// Papers in Marine Science 44 (1983), after Saunders and Fofonoff (1976). It agrees with the
/// integral of the equation of state within 0.1 m, to 10 000 dbar. Above the surface, depth and
/// pressure are negative.
inline double unesco_depth_m(double sea_pressure_pa, double latitude_rad) {
  const double p = sea_pressure_pa / ocean::decibar_pa;
  return ocean::volume_integral(p) /
         (ocean::surface_gravity(latitude_rad) + ocean::gravity_per_decibar * p);
}

inline double unesco_pressure_pa(double depth_m, double latitude_rad) {
  const double g = ocean::surface_gravity(latitude_rad);
  double p = depth_m;  // a metre is nearly a decibar; each Newton step doubles the digits
  for (int step = 0; step < 4; ++step) {
    const double excess =
        ocean::volume_integral(p) - depth_m * (g + ocean::gravity_per_decibar * p);
    p -= excess / (ocean::volume_slope(p) - depth_m * ocean::gravity_per_decibar);
  }
  return p * ocean::decibar_pa;
}

/// The Challenger Deep has 10.9 km of water and 1130 bar (NOAA); no sea has more than these.
inline constexpr double deepest_sea_m = 12e3;
inline constexpr double deepest_sea_pa = 1.2e8;

/// False for an absolute pressure that no sensor in a sea can have, and for NaN.
inline bool is_sea_pressure(double absolute_pa) {
  return absolute_pa >= 0 && absolute_pa <= deepest_sea_pa;
}

/// False for a depth that no vehicle in a sea or on its deck can have, and for NaN.
inline bool is_sea_depth(double depth_m) {
  constexpr double highest_deck_m = 100;
  return depth_m >= -highest_deck_m && depth_m <= deepest_sea_m;
}

/// The water above a pressure sensor. With one density under standard gravity
///  depth = (p - p_surface) / (density g),  g = 9.80665 m/s2,
/// or, if a latitude is given, standard ocean water (salinity 35, 0 deg C) as in EOS-80.
struct WaterColumn {
  double surface_pressure_pa = 101'325;
  double density_kgm3 = 1025;
  std::optional<double> unesco_latitude_rad;

  double depth_m(double pressure_pa) const;
};

inline double WaterColumn::depth_m(double pressure_pa) const {
  const double sea_pressure = pressure_pa - surface_pressure_pa;
  if (unesco_latitude_rad) return unesco_depth_m(sea_pressure, *unesco_latitude_rad);
  return sea_pressure / (density_kgm3 * units::standard_gravity);
}

}  // namespace drydock::measurement
