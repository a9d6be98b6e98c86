#include "drivers/device/water_column.hpp"

#include <cmath>

namespace drydock::device {

namespace {

constexpr double standard_gravity_mps2 = 9.80665;
constexpr double decibar_pa = 1e4;

/// Gravity at the surface, m/s2 (Anon. 1970, as the report quotes it).
double surface_gravity(double latitude_rad) {
  const double x = std::sin(latitude_rad) * std::sin(latitude_rad);
  return 9.780318 * (1 + (5.2788e-3 + 2.36e-5 * x) * x);
}

constexpr double gravity_per_decibar = 1.092e-6;  // half the increase with depth: the column's mean

/// Specific volume of the standard ocean summed over pressure, m2/s2, and its derivative.
double volume_integral(double p) {
  return (((-1.82e-15 * p + 2.279e-10) * p - 2.2512e-5) * p + 9.72659) * p;
}
double volume_slope(double p) {
  return ((-4 * 1.82e-15 * p + 3 * 2.279e-10) * p - 2 * 2.2512e-5) * p + 9.72659;
}

}  // namespace

double unesco_depth_m(double sea_pressure_pa, double latitude_rad) {
  const double p = sea_pressure_pa / decibar_pa;
  return volume_integral(p) / (surface_gravity(latitude_rad) + gravity_per_decibar * p);
}

double unesco_pressure_pa(double depth_m, double latitude_rad) {
  const double g = surface_gravity(latitude_rad);
  double p = depth_m;  // a metre is nearly a decibar: Newton's steps then double the digits
  for (int step = 0; step < 4; ++step) {
    const double excess = volume_integral(p) - depth_m * (g + gravity_per_decibar * p);
    p -= excess / (volume_slope(p) - depth_m * gravity_per_decibar);
  }
  return p * decibar_pa;
}

double WaterColumn::depth_m(double pressure_pa) const {
  const double sea_pressure = pressure_pa - surface_pressure_pa;
  if (unesco_latitude_rad) return unesco_depth_m(sea_pressure, *unesco_latitude_rad);
  return sea_pressure / (density_kgm3 * standard_gravity_mps2);
}

}  // namespace drydock::device
