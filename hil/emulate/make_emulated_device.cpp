#include "hil/emulate/make_emulated_device.hpp"

#include <boost/throw_exception.hpp>
#include <stdexcept>

#include "drivers/measurement/actuator_order.hpp"
#include "drivers/wire/described/description.hpp"
#include "hil/emulate/booting_device.hpp"
#include "hil/emulate/described/make_described.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/emulate/gnss/make_sky.hpp"

namespace drydock::emulate {
namespace {

using Make = DevicePtr (*)(const DeviceSetup&);

/// Null: no device of that kind speaks the protocol.
Make maker_of(const DeviceConfig& config) {
  if (config.description)
    return config.description->facts.kinds.has(config.kind) ? make_described : nullptr;
  for (const DeviceRow& row : device_rows)
    if (row.kind == config.kind && row.protocol == config.protocol) return row.make;
  return nullptr;
}

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

/// True for a drive of a thruster where the motion has none for it.
bool moves_what_is_not_there(const DeviceConfig& config, const Trajectory& trajectory) {
  if (config.kind != rig_config::DeviceKind::actuator || config.description) return false;
  const int thruster = config.instance.value_or(0) - measurement::first_thruster_number;
  return thruster >= 0 && config.protocol == "cia402" &&
         trajectory.at(trajectory.start()).thruster_radps.size() <=
             static_cast<std::size_t>(thruster);
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
  const Make make = maker_of(config);
  if (make == nullptr) return unknown_protocol(config);
  if (moves_what_is_not_there(config, trajectory))
    return EmulateError{"device \"" + config.name + "\": the emulated vehicle has no thruster " +
                            std::to_string(*config.instance) + ", allowed: 0 to 3",
                        "instance"};
  const auto& emulated = config.emulate;
  const Stamp booted = power.boot + measurement::from_seconds(emulated.boot_s);
  const auto condition = power.condition ? power.condition : std::make_shared<const Condition>();
  DeviceSetup setup{config, trajectory, seed, nullptr, booted, condition, power.memory};
  if (config.kind == rig_config::DeviceKind::gnss) {
    auto sky = make_sky(config, trajectory.start(), seed);
    if (!sky) return sky.error();
    setup.sky = std::move(*sky);
  }
  if (emulated.boot_s == 0 && emulated.banner.empty()) return make(setup);
  return std::make_unique<BootingDevice>(make(setup), booted, emulated.banner);
}

}  // namespace drydock::emulate
