#include "drivers/recordings/slice/displacement.hpp"

#include <cmath>
#include <numbers>

namespace drydock::slice {

namespace {

/// Metres per radian north and east (WGS-84), divided by the semi-major axis.
struct Radii {
  double meridian, parallel;
};

Radii radii_at(double latitude_rad) {
  constexpr double flattening = 1 / 298.257223563;
  constexpr double eccentricity_squared = flattening * (2 - flattening);
  const double sine = std::sin(latitude_rad);
  const double root = std::sqrt(1 - eccentricity_squared * sine * sine);
  return {(1 - eccentricity_squared) / (root * root * root), std::cos(latitude_rad) / root};
}

}  // namespace

Displacement::Displacement(const measurement::Geodetic& to) : to_(to) {}

void Displacement::start_at(const measurement::Geodetic& from) {
  if (from_) return;
  from_ = from;
  const Radii here = radii_at(from.latitude_rad), there = radii_at(to_.latitude_rad);
  north_scale_ = here.meridian / there.meridian;
  east_scale_ = here.parallel / there.parallel;
}

double Displacement::latitude(double latitude_rad) const {
  return from_ ? to_.latitude_rad + (latitude_rad - from_->latitude_rad) * north_scale_
               : to_.latitude_rad;
}

double Displacement::longitude(double longitude_rad) const {
  constexpr double turn = 2 * std::numbers::pi;
  if (!from_) return to_.longitude_rad;
  const double east = std::remainder(longitude_rad - from_->longitude_rad, turn);
  return std::remainder(to_.longitude_rad + east * east_scale_, turn);
}

}  // namespace drydock::slice
