#include "drivers/shell/rig_devices.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drivers/link/uri.hpp"
#include "drivers/shell/baud_search.hpp"
#include "drivers/shell/imu_settings.hpp"
#include "drivers/wire/j1939/j1939.hpp"
#include "drivers/wire/ubx/ubx_settings.hpp"

namespace drydock::shell {

namespace {

using device::DeviceOptions;
using rig_config::DeviceConfig;

RigDevicesError error_in(const rig_config::Rig& rig, const DeviceConfig& config,
                         std::string_view what) {
  std::string text = rig.file;
  text.append(":").append(std::to_string(config.line)).append(": device \"");
  text.append(config.name).append("\": ").append(what);
  return {text};
}

device::SoundSpeedOptions sound_speed_options(const rig_config::SoundSpeedConfig& config) {
  using Source = device::SoundSpeedOptions::Source;
  return {.source = config.source == "fixed"      ? Source::fixed
                    : config.source == "computed" ? Source::computed
                                                  : Source::as_sent,
          .fixed_mps = config.mps,
          .equation = config.equation == "medwin" ? measurement::SoundSpeedEquation::medwin
                                                  : measurement::SoundSpeedEquation::mackenzie,
          .salinity_ppt = config.salinity_ppt,
          .temperature_k = config.temperature_k,
          .depth_m = config.depth_m,
          .set_mps = config.set_mps};
}

device::UbloxSettings ublox_settings(const rig_config::UbloxConfig& config) {
  device::UbloxSettings settings;
  if (config.rate_hz)
    settings.period = std::chrono::milliseconds{std::lround(1000 / *config.rate_hz)};
  for (const auto& message : config.messages)
    settings.messages.push_back({wire::ubx::message_named(message.name).value(),
                                 static_cast<std::uint8_t>(message.epochs)});
  return settings;
}

device::DriverOptions driver_options(const DeviceConfig& config, std::size_t index,
                                     const link::Uri& uri) {
  device::DriverOptions options;
  options.kind = config.kind;
  options.protocol = config.protocol;
  options.description = config.description;
  options.poll_period = measurement::from_seconds(1 / config.rate_hz);
  options.device = static_cast<std::uint16_t>(index);
  options.mounting = {config.mounting_rad[0], config.mounting_rad[1], config.mounting_rad[2]};
  options.latency = measurement::from_seconds(config.latency_s);
  options.baud = uri.baud();
  options.byte_frame = uri.byte_frame();
  options.bitrate = uri.bitrate().value_or(options.bitrate);
  options.data_bitrate = uri.data_bitrate();
  options.address = static_cast<std::uint8_t>(config.address);
  if (config.instance) options.instance = static_cast<std::uint8_t>(*config.instance);
  options.canopen.heartbeat_timeout = measurement::from_seconds(config.heartbeat_timeout_s);
  if (config.sync) options.canopen.sync_period = measurement::from_seconds(1 / config.rate_hz);
  options.water = {config.surface_pressure_pa, config.water_density_kgm3,
                   config.unesco_latitude_rad};
  options.velocity_sigma_mps = config.velocity_sigma_mps;
  options.speed_scale = config.speed_scale;
  options.compass_error_rad = config.compass_error_rad;
  options.dvl.maker = config.maker;
  options.dvl.beam_angle_rad = config.beam_angle_rad;
  options.dvl.levelled = config.levelled;
  options.dvl.velocity_of_bed = config.velocity_of_bed;
  options.dvl.sound_speed = sound_speed_options(config.sound_speed);
  options.ublox = ublox_settings(config.ublox);
  if (const auto& water_linked = config.water_linked) {
    options.dvl.water_linked = {water_linked->sound_speed_mps,  water_linked->mounting_rotation_rad,
                                water_linked->old_sentences,    water_linked->range_mode,
                                water_linked->acoustic_enabled, water_linked->periodic_cycling};
  }
  return options;
}

/// A line that searches its rate listens at least this long at each rate.
constexpr std::chrono::nanoseconds shortest_trial = std::chrono::seconds{2};

device::LifeCycleOptions life_cycle_options(const DeviceConfig& config, const link::Uri& uri) {
  device::LifeCycleOptions options;
  options.stale_after = measurement::from_seconds(config.stale_after_s);
  options.reopen_after = measurement::from_seconds(config.reopen_after_s);
  if (searches_baud(uri)) {
    constexpr double messages = 4;  // as many as would come at the right rate
    options.reopen_after =
        std::max(shortest_trial, measurement::from_seconds(messages / config.rate_hz));
    options.reopen_in_place = true;
  }
  if (uri.recorded()) {
    options.reopen_when_quiet = false;  // opening a recording again would restart it
    options.quiet_but_up = " in the recording";
  } else if (uri.carries() == link::Carries::frames) {
    options.reopen_when_quiet = false;
    // Whether an adapter is open, its silence does not tell.
    if (uri.scheme == link::Scheme::slcan)
      options.quiet_but_up = "; its channel is opened again in case the adapter was reset";
    if (uri.scheme == link::Scheme::gateway) options.quiet_but_up = " from the gateway";
  }
  return options;
}

boost::system::result<DeviceOptions, DeviceRefusal> options_of(const DeviceConfig& config,
                                                               std::size_t index) {
  const auto uri = link::parse_uri(config.link);
  if (!uri) return DeviceRefusal{"link", uri.error().message};
  if (config.address < 0 || config.address >= wire::j1939::null_address) {
    return DeviceRefusal{"address", "address " + std::to_string(config.address) +
                                        " is no bus address; allowed: 0 (any) to " +
                                        std::to_string(wire::j1939::null_address - 1)};
  }
  DeviceOptions options;
  options.name = config.name;
  options.link = config.link;
  options.driver = driver_options(config, index, *uri);
  const auto aceinna = aceinna_settings(config.aceinna);
  if (!aceinna) return DeviceRefusal{aceinna.error().key, aceinna.error().message};
  options.driver.aceinna = *aceinna;
  const auto xsens = xsens_identifiers(config.xsens);
  if (!xsens) return DeviceRefusal{xsens.error().key, xsens.error().message};
  options.driver.xsens_identifiers = *xsens;
  const auto& pressure = config.pressure;
  const auto scale = wire::cia404_pressure::find_scale(pressure.format, pressure.unit,
                                                       static_cast<unsigned>(pressure.decimals));
  if (!scale)
    return DeviceRefusal{"pressure", "no pressure in " + pressure.format + " " + pressure.unit};
  options.driver.pressure = {*scale, pressure.gauge};
  options.life_cycle = life_cycle_options(config, *uri);
  options.nominal_rate_hz = config.rate_hz;
  return options;
}

std::string wrong_carrier(const DeviceConfig& config, bool on_bus) {
  return on_bus ? "protocol \"" + config.protocol + "\" needs a CAN link, \"" + config.link +
                      "\" carries bytes; allowed: socketcan slcan memory-can can:auto file"
                : "protocol \"" + config.protocol + "\" needs a byte link, \"" + config.link +
                      "\" carries CAN frames; allowed: serial pty tcp udp file memory";
}

}  // namespace

boost::system::result<DeviceOptions, RigDevicesError> device_options(const rig_config::Rig& rig,
                                                                     std::size_t index) {
  const DeviceConfig& config = rig.devices.at(index);
  auto options = options_of(config, index);
  if (!options) return error_in(rig, config, options.error().message);
  return std::move(*options);
}

boost::system::result<std::unique_ptr<device::Device>, DeviceRefusal> make_device(
    const rig_config::Rig& rig, std::size_t index) {
  const DeviceConfig& config = rig.devices.at(index);
  auto options = options_of(config, index);
  if (!options) return options.error();
  const auto uri = link::parse_uri(config.link);
  auto made = device::Device::make(std::move(*options));
  if (!made) return DeviceRefusal{"protocol", made.error().message};
  const bool on_bus = (*made)->on_bus();
  const auto needed = on_bus ? link::Carries::frames : link::Carries::bytes;
  if (!uri->may_carry(needed)) return DeviceRefusal{"link", wrong_carrier(config, on_bus)};
  if (uri->recorded()) {
    const std::string misfit = link::recording_misfit(*uri, needed);
    if (!misfit.empty()) return DeviceRefusal{"link", misfit};
  }
  return std::move(*made);
}

boost::system::result<std::vector<std::unique_ptr<device::Device>>, RigDevicesError> make_devices(
    const rig_config::Rig& rig) {
  std::vector<std::unique_ptr<device::Device>> devices;
  for (std::size_t i = 0; i < rig.devices.size(); ++i) {
    auto made = make_device(rig, i);
    if (!made) return error_in(rig, rig.devices[i], made.error().message);
    devices.push_back(std::move(*made));
  }
  return devices;
}

}  // namespace drydock::shell
