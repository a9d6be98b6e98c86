#include "hil/emulate/make_emulated_device.hpp"

#include <array>
#include <boost/throw_exception.hpp>
#include <stdexcept>
#include <string_view>

#include "hil/emulate/booting_device.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/emulate/gnss/make_sky.hpp"

namespace drydock::emulate {
namespace {

using rig_config::DeviceKind;

struct Entry {
  DeviceKind kind;
  std::string_view protocol;
  DevicePtr (*make)(const DeviceSetup&);
};

constexpr auto catalogue = std::to_array<Entry>({
    {DeviceKind::dvl, "pd0", make_pd0_dvl},
    {DeviceKind::dvl, "pd4", make_pd4_dvl},
    {DeviceKind::dvl, "pd5", make_pd5_dvl},
    {DeviceKind::dvl, "pd6", make_pd6_dvl},
    {DeviceKind::dvl, "water-linked", make_water_linked_dvl},
    {DeviceKind::dvl, "nortek", make_nortek_dvl},
    {DeviceKind::emlog, "nmea0183", make_nmea0183_em_log},
    {DeviceKind::gnss, "ubx", make_ubx_gnss},
    {DeviceKind::gnss, "nmea0183", make_nmea0183_gnss},
    {DeviceKind::imu, "aceinna", make_aceinna_imu},
    {DeviceKind::imu, "cia404-imu", make_cia404_imu},
    {DeviceKind::imu, "epson-g550", make_epson_g550},
    {DeviceKind::imu, "epson-g552", make_epson_g552},
    {DeviceKind::imu, "xsens", make_xsens_imu},
    {DeviceKind::depth, "nmea2000", make_nmea2000_depth},
    {DeviceKind::depth, "cia404-pressure", make_cia404_pressure},
    {DeviceKind::actuator, "nmea2000", make_nmea2000_actuators},
});

EmulateError unknown_protocol(const DeviceConfig& config) {
  std::string allowed;
  for (const Entry& entry : catalogue) {
    if (entry.kind != config.kind) continue;
    allowed += (allowed.empty() ? "" : ", ") + std::string(entry.protocol);
  }
  return {"device \"" + config.name + "\": no emulated " + std::string(to_string(config.kind)) +
          " speaks \"" + config.protocol + "\"; allowed: " + allowed};
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
    return EmulateError{"device \"" + config.name + "\": rate_hz must be above 0"};
  }
  for (const Entry& entry : catalogue) {
    if (entry.kind == config.kind && entry.protocol == config.protocol) {
      const auto& emulated = config.emulate;
      const Stamp booted = power.boot + measurement::from_seconds(emulated.boot_s);
      DeviceSetup setup{config, trajectory, seed, nullptr, booted, power.condition};
      if (config.kind == DeviceKind::gnss) {
        auto sky = make_sky(config, trajectory.start(), seed);
        if (!sky) return sky.error();
        setup.sky = std::move(*sky);
      }
      if (emulated.boot_s == 0 && emulated.banner.empty()) return entry.make(setup);
      return std::make_unique<BootingDevice>(entry.make(setup), booted, emulated.banner);
    }
  }
  return unknown_protocol(config);
}

}  // namespace drydock::emulate
