#pragma once

#include <cstdint>
#include <string_view>

#include "hil/sensor/random.hpp"
#include "hil/sensor/sky.hpp"
#include "hil/sky/broadcast_orbits.hpp"
#include "rig_config/rig.hpp"

namespace drydock::sky {

/// The satellites of a broadcast ephemeris as one receiver tracks them: all above its mask. Each
/// C/N0 comes from the antenna's pattern and the vehicle's attitude, with noise, in whole dB as
/// receivers report it (docs/world/sky.md eq. (13) to (16)). Tracked satellites are marked as used.
class BroadcastSky final : public sensor::Sky {
 public:
  /// If `config.at_utc_ns` sets the sky to another day, the sky has that time at `mission_start`
  /// and continues from there.
  BroadcastSky(BroadcastOrbits orbits, const rig_config::SkyConfig& config,
               measurement::Stamp mission_start, std::uint64_t seed, std::string_view device);

  measurement::GnssSatellites at(const motion::Truth& truth) override;

  GpsTime sky_time(measurement::Stamp bench) const { return gps_time(bench + ahead_); }
  const BroadcastOrbits& orbits() const { return orbits_; }

 private:
  std::optional<double> cno_dbhz(const Eigen::Vector3d& toward_body);

  BroadcastOrbits orbits_;
  rig_config::SkyConfig config_;
  Eigen::Vector3d boresight_body_;
  std::chrono::nanoseconds ahead_{};
  sensor::RandomStream noise_;
};

}  // namespace drydock::sky
