#include "hil/sky/broadcast_sky.hpp"

#include <cmath>

#include "hil/sky/antenna.hpp"
#include "hil/sky/look.hpp"

namespace drydock::sky {

BroadcastSky::BroadcastSky(BroadcastOrbits orbits, const rig_config::SkyConfig& config,
                           measurement::Stamp mission_start, std::uint64_t seed,
                           std::string_view device)
    : orbits_(std::move(orbits)),
      config_(config),
      boresight_body_(config.antenna_axis.data()),
      noise_(seed, device, "signal power") {
  if (config.at_utc_ns) ahead_ = measurement::stamp_from_ns(*config.at_utc_ns) - mission_start;
}

measurement::GnssSatellites BroadcastSky::at(const motion::Truth& truth) {
  measurement::GnssSatellites sky;
  sky.origin.valid_at = truth.at;
  const GpsTime time = sky_time(truth.at);
  const frame::Position place{truth.latitude_rad, truth.longitude_rad, truth.height_m};
  for (int prn = 1; prn <= highest_prn; ++prn) {
    const Ephemeris* record = orbits_.nearest(prn, time);
    if (record == nullptr) continue;
    const Look look = look_at(*record, time, place);
    if (look.elevation_rad < config_.elevation_mask_rad) continue;
    measurement::Satellite satellite;
    satellite.number = record->prn;
    satellite.azimuth_rad = look.azimuth_rad;
    satellite.elevation_rad = look.elevation_rad;
    satellite.cno_dbhz = cno_dbhz(truth.body_to_ned.conjugate() * look.toward_ned);
    satellite.used = satellite.cno_dbhz.has_value();
    sky.satellites.push_back(satellite);
  }
  return sky;
}

std::optional<double> BroadcastSky::cno_dbhz(const Eigen::Vector3d& toward_body) {
  const double elevation = antenna_elevation(toward_body, boresight_body_);  // (13)
  const double power =
      antenna_power(elevation) + config_.power_noise * noise_.normal();  // (14), (15)
  if (power <= 0) return std::nullopt;
  const double cno = std::round(config_.boresight_cno_dbhz + 10 * std::log10(power));  // (16)
  return cno >= config_.lowest_cno_dbhz ? std::optional{cno} : std::nullopt;
}

}  // namespace drydock::sky
