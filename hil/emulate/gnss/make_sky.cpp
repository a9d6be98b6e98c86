#include "hil/emulate/gnss/make_sky.hpp"

#include <fmt/format.h>

#include "hil/sky/broadcast_sky.hpp"
#include "hil/sky/ephemeris_file.hpp"

namespace drydock::emulate {
namespace {

/// Without this error the satellites would be missing without any message, so the mission must not
/// begin.
EmulateError out_of_date(const rig_config::DeviceConfig& config, const sky::BroadcastOrbits& orbits,
                         sky::GpsTime time) {
  const auto [first, last] = orbits.span();
  return {
      fmt::format("device \"{}\": at {} no satellite has a healthy record within 2 h in {}, whose "
                  "records are of "
                  "{} to {}; set at in its sky table, or start in [rig] and --speed max",
                  config.name, to_string(time), config.emulate.sky->ephemeris, to_string(first),
                  to_string(last)),
      "emulate/sky/at"};
}

}  // namespace

boost::system::result<std::shared_ptr<sensor::Sky>, EmulateError> make_sky(
    const rig_config::DeviceConfig& config, measurement::Stamp mission_start, std::uint64_t seed) {
  if (!config.emulate.sky) return std::make_shared<sensor::InventedSky>();
  const auto file = sky::read_navigation_file(config.emulate.sky->ephemeris);
  if (!file)
    return EmulateError{"device \"" + config.name + "\": " + file.error().message,
                        "emulate/sky/ephemeris"};
  auto broadcast = std::make_shared<sky::BroadcastSky>(
      sky::BroadcastOrbits(file->records), *config.emulate.sky, mission_start, seed, config.name);
  const sky::GpsTime begins = broadcast->sky_time(mission_start);
  if (broadcast->orbits().usable(begins) == 0)
    return out_of_date(config, broadcast->orbits(), begins);
  return std::shared_ptr<sensor::Sky>(std::move(broadcast));
}

}  // namespace drydock::emulate
