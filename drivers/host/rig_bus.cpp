#include "drivers/host/rig_bus.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drivers/link/uri.hpp"

namespace drydock::host {
namespace {

bus::Level level_of(device::State state) {
  switch (state) {
    case device::State::streaming: return bus::Level::ok;
    case device::State::stale: return bus::Level::stale;
    case device::State::backing_off: return bus::Level::error;
    default: return bus::Level::warn;
  }
}

}  // namespace

measurement::Provenance provenance_of(const std::string& link) {
  using measurement::Provenance;
  const auto uri = link::parse_uri(link);
  if (!uri) return Provenance::real;
  if (uri->recorded()) return Provenance::replayed;
  return uri->emulated() ? Provenance::emulated : Provenance::real;
}

std::vector<bus::Device> bus_devices(const rig_config::Rig& rig) {
  std::vector<bus::Device> devices;
  for (const auto& config : rig.devices) {
    // Both enumerations follow the order of the rig file's `kind`.
    devices.push_back({.name = config.name,
                       .kind = static_cast<bus::Kind>(config.kind),
                       .provenance = provenance_of(config.link)});
  }
  return devices;
}

std::vector<bus::Device> bus_devices(std::span<const std::unique_ptr<device::Device>> devices) {
  std::vector<bus::Device> all;
  for (const auto& device : devices) {
    all.push_back({.name = std::string(device->name()),
                   .kind = static_cast<bus::Kind>(device->options().driver.kind),
                   .provenance = provenance_of(device->options().link)});
  }
  return all;
}

std::vector<std::string> estimator_names(const rig_config::Rig& rig) {
  std::vector<std::string> names;
  for (const auto& estimator : rig.estimators) names.push_back(estimator.name);
  return names;
}

std::vector<std::string> navigator_names(const rig_config::Rig& rig) {
  std::vector<std::string> names;
  for (const auto& estimator : rig.estimators)
    if (rig_config::facts_of(estimator.kind).gives_positions) names.push_back(estimator.name);
  return names;
}

std::vector<bus::InnovationSource> innovation_sources(const rig_config::Rig& rig) {
  std::vector<bus::InnovationSource> sources;
  for (std::size_t i = 0; i < rig.estimators.size(); ++i) {
    for (const std::string& name : rig_config::devices_compared_by(rig.estimators[i].kind)) {
      const auto device = std::ranges::find(rig.devices, name, &rig_config::DeviceConfig::name);
      if (device == rig.devices.end()) continue;
      sources.push_back({static_cast<std::uint16_t>(i),
                         static_cast<std::uint16_t>(device - rig.devices.begin())});
    }
  }
  return sources;
}

bus::DeviceStatus status_of(const device::Device& device, const device::Health& health) {
  const auto count = [](std::uint64_t n) { return std::to_string(n); };
  const auto& options = device.options();
  bus::DeviceStatus status{.level = level_of(health.state),
                           .name = device.name(),
                           .message = std::string{to_string(health.state)},
                           .hardware_id = options.link,
                           .values = {}};
  status.values = {
      {"kind", std::string{device::to_string(options.driver.kind)}},
      {"protocol", options.driver.protocol},
      {"provenance", std::string{measurement::to_string(provenance_of(options.link))}},
      {"rate_hz", fmt::format("{:.3f}", health.rate_hz.value_or(0))},
      {"nominal_rate_hz", fmt::format("{:.3f}", health.nominal_rate_hz)},
      {"jitter_s", health.jitter ? fmt::format("{:.6f}", health.jitter->deviation_s) : ""},
      {"longest_interval_s",
       health.jitter ? fmt::format("{:.6f}", health.jitter->longest_interval_s) : ""},
      {"age_s", health.age ? fmt::format("{:.3f}", measurement::seconds(*health.age)) : ""},
      {"status", std::string{health.status.view()}},
      {"messages", count(health.messages)},
      {"frames", count(health.stream.frames)},
      {"bytes_in", count(health.stream.bytes_in)},
      {"bytes_good", count(health.stream.bytes_good)},
      {"bytes_skipped", count(health.stream.bytes_skipped)},
      {"bad_checksums", count(health.stream.bad_checksums)},
      {"reopened", count(health.reopened)},
      {"can_dropped", count(health.can_dropped)},
      {"error_frames", count(health.error_frames)},
      {"last_error", std::string{health.last_error.view()}},
  };
  return status;
}

}  // namespace drydock::host
