#include <cmath>
#include <cstdlib>
#include <string_view>

#include "rig_config/load.hpp"

using namespace drydock::rig_config;

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

/// True if it is refused, with lines that say where and what.
template <class Value>
bool refused_in_words(const Loaded<Value>& loaded) {
  if (loaded) return false;
  require(!loaded.error().empty());
  for (const Problem& problem : loaded.error())
    require(!problem.path.empty() && !problem.what.empty() && problem.line >= 0);
  return true;
}

}  // namespace

/// Any text as each kind of configuration file gives usable values, or problems.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text{reinterpret_cast<const char*>(data), size};
  const std::string path = "/nowhere/file.toml";
  const LoadOptions drivers_alone{.link_check = {}, .devices_only = true};
  if (const auto rig = load_rig_text(text, path, drivers_alone); !refused_in_words(rig)) {
    require(!rig->devices.empty() && rig->devices.size() <= 256);
    for (const auto& device : rig->devices)
      require(std::isfinite(device.rate_hz) && device.rate_hz > 0 && device.stale_after_s > 0);
  }
  refused_in_words(load_rig_text(text, path));
  if (const auto mission = load_mission_text(text, path); !refused_in_words(mission))
    require(std::isfinite(mission->speed_mps) && std::isfinite(mission->depth_m));
  if (const auto vehicle = load_vehicle_text(text, path); !refused_in_words(vehicle))
    require(std::isfinite(vehicle->length_m) && vehicle->length_m > 0);
  for (const auto kind : {DeviceKind::dvl, DeviceKind::imu, DeviceKind::gnss})
    if (const auto sensor = load_sensor_text(text, path, kind); !refused_in_words(sensor))
      for (const double bias : sensor->primary.bias) require(std::isfinite(bias));
  return 0;
}
