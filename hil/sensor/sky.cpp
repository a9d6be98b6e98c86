#include "hil/sensor/sky.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "drivers/measurement/units.hpp"
#include "estimators/frame/attitude.hpp"

namespace drydock::sensor {
namespace {

struct Pass {
  std::uint8_t number;
  double azimuth_deg, elevation_deg;
};

constexpr std::array<Pass, 10> passes{{{2, 15, 62},
                                       {5, 60, 18},
                                       {7, 98, 41},
                                       {9, 133, 12},
                                       {13, 170, 33},
                                       {16, 205, 74},
                                       {20, 241, 24},
                                       {26, 279, 52},
                                       {29, 312, 15},
                                       {30, 347, 37}}};

constexpr double orbit_s = 43082;          // half a sidereal day
constexpr double elevation_swing_deg = 8;  // keeps all ten satellites above the horizon mask of 4
                                           // deg

}  // namespace

measurement::GnssSatellites ideal_sky(const motion::Truth& truth, bool under_water) {
  measurement::GnssSatellites sky;
  sky.origin.valid_at = truth.at;
  if (under_water) return sky;
  const double turn = 2 * std::numbers::pi *
                      std::fmod(measurement::seconds(truth.at.time_since_epoch()), orbit_s) /
                      orbit_s;
  for (const Pass& pass : passes) {
    const double azimuth = frame::wrap_pi(pass.azimuth_deg * units::degree + turn);
    const double elevation =
        units::degree * (pass.elevation_deg + elevation_swing_deg * std::sin(turn + pass.number));
    measurement::Satellite satellite;
    satellite.number = pass.number;
    satellite.azimuth_rad = azimuth < 0 ? azimuth + 2 * std::numbers::pi : azimuth;
    satellite.elevation_rad = elevation;
    satellite.cno_dbhz = 34 + 14 * std::sin(elevation);
    satellite.used = elevation > 10 * units::degree;
    sky.satellites.push_back(satellite);
  }
  return sky;
}

}  // namespace drydock::sensor
