#include "hil/sky/orbit.hpp"

#include <fmt/format.h>

#include <cmath>

#include "drivers/measurement/units.hpp"

namespace drydock::sky {
namespace {

/// Kepler's equation (2) by Newton's method. For e below 0.03, three iterations reach rounding
/// error.
double eccentric_anomaly(double mean, double e) {
  double anomaly = mean;
  for (int turn = 0; turn < 4; ++turn)
    anomaly -= (anomaly - e * std::sin(anomaly) - mean) / (1 - e * std::cos(anomaly));
  return anomaly;
}

}  // namespace

SatelliteState satellite_at(const Ephemeris& r, GpsTime time) {
  const double t = measurement::seconds(time - r.toe);
  const double a = r.sqrt_a * r.sqrt_a;
  const double mean = r.m0_rad + (std::sqrt(gps_mu / (a * a * a)) + r.delta_n_radps) * t;  // (1)
  const double anomaly = eccentric_anomaly(mean, r.e);                                     // (2)
  const double sin_e = std::sin(anomaly), cos_e = std::cos(anomaly);
  const double latitude =
      std::atan2(std::sqrt(1 - r.e * r.e) * sin_e, cos_e - r.e) + r.omega_rad;  // (3)

  const double s2 = std::sin(2 * latitude), c2 = std::cos(2 * latitude);
  const double u = latitude + r.cus_rad * s2 + r.cuc_rad * c2;                     // (4)
  const double radius = a * (1 - r.e * cos_e) + r.crs_m * s2 + r.crc_m * c2;       // (5)
  const double i = r.i0_rad + r.idot_radps * t + r.cis_rad * s2 + r.cic_rad * c2;  // (6)
  const double node = r.omega0_rad + (r.omega_dot_radps - gps_earth_rate) * t -
                      gps_earth_rate * measurement::seconds(week_of(r.toe).of_week);  // (7)

  const double x = radius * std::cos(u), y = radius * std::sin(u);
  SatelliteState state;
  state.ecef_m = {x * std::cos(node) - y * std::cos(i) * std::sin(node),
                  x * std::sin(node) + y * std::cos(i) * std::cos(node), y * std::sin(i)};  // (8)
  const double since_toc = measurement::seconds(time - r.toc);
  state.relativity_s = gps_relativity * r.e * r.sqrt_a * sin_e;  // (9)
  state.clock_s =
      r.af0_s + since_toc * (r.af1 + since_toc * r.af2_ps) + state.relativity_s;  // (10)
  return state;
}

std::optional<std::string> absurd(const Ephemeris& record) {
  constexpr double nominal_km = 26560, axis_slack_km = 500, radius_slack_km = 1500;
  constexpr double highest_e = 0.03, lowest_i = 48 * units::degree, highest_i = 62 * units::degree;
  const double axis_km = record.sqrt_a * record.sqrt_a / 1000;
  if (!(std::abs(axis_km - nominal_km) <= axis_slack_km))
    return fmt::format("semi-major axis {:.0f} km, expected {:.0f} +- {:.0f} km", axis_km,
                       nominal_km, axis_slack_km);
  if (!(record.e >= 0 && record.e <= highest_e))
    return fmt::format("eccentricity {:.4g}, expected 0 to {}", record.e, highest_e);
  if (!(record.i0_rad >= lowest_i && record.i0_rad <= highest_i))
    return fmt::format("inclination {:.1f} deg, expected {:.0f} to {:.0f} deg",
                       record.i0_rad / units::degree, lowest_i / units::degree,
                       highest_i / units::degree);
  const double radius_km = satellite_at(record, record.toe).ecef_m.norm() / 1000;
  if (!(std::abs(radius_km - nominal_km) <= radius_slack_km))
    return fmt::format("{:.0f} km from the Earth's centre at toe, expected {:.0f} +- {:.0f} km",
                       radius_km, nominal_km, radius_slack_km);
  return std::nullopt;
}

}  // namespace drydock::sky
