#include "hil/emulate/make_emulated_device.hpp"

#include <boost/throw_exception.hpp>
#include <stdexcept>

#include "hil/emulate/booting_device.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/emulate/gnss/make_sky.hpp"

namespace drydock::emulate {
namespace {

EmulateError unknown_protocol(const DeviceConfig& config) {
  std::string allowed;
  for (const DeviceRow& row : device_rows) {
    if (row.kind != config.kind) continue;
    allowed += (allowed.empty() ? "" : ", ") + std::string(row.protocol);
  }
  return {"device \"" + config.name + "\": no emulated " + std::string(to_string(config.kind)) +
              " speaks \"" + config.protocol + "\"; allowed: " + allowed,
          "protocol"};
}

}  // namespace

void throw_exception_from_error(const EmulateError& error, const boost::source_location& where) {
  boost::throw_exception(std::invalid_argument(error.message), where);
}

boost::system::result<DevicePtr, EmulateError> make_emulated_device(const DeviceConfig& config,
                                                                    const Trajectory& trajectory,
                                                                    std::uint64_t seed) {
  return make_emulated_device(config, trajectory, seed,
                              {trajectory.start(), std::make_shared<Condition>()});
}

boost::system::result<DevicePtr, EmulateError> make_emulated_device(const DeviceConfig& config,
                                                                    const Trajectory& trajectory,
                                                                    std::uint64_t seed,
                                                                    const PowerUp& power) {
  if (!(config.rate_hz > 0)) {
    return EmulateError{"device \"" + config.name + "\": rate_hz must be above 0", "rate_hz"};
  }
  for (const DeviceRow& row : device_rows) {
    if (row.kind == config.kind && row.protocol == config.protocol) {
      const auto& emulated = config.emulate;
      const Stamp booted = power.boot + measurement::from_seconds(emulated.boot_s);
      DeviceSetup setup{config, trajectory, seed, nullptr, booted, power.condition};
      if (config.kind == rig_config::DeviceKind::gnss) {
        auto sky = make_sky(config, trajectory.start(), seed);
        if (!sky) return sky.error();
        setup.sky = std::move(*sky);
      }
      if (emulated.boot_s == 0 && emulated.banner.empty()) return row.make(setup);
      return std::make_unique<BootingDevice>(row.make(setup), booted, emulated.banner);
    }
  }
  return unknown_protocol(config);
}

}  // namespace drydock::emulate
