#include "drivers/host/rig_bus.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drivers/device/health_account.hpp"
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

std::string in_text(const std::string& text) { return text; }
std::string in_text(std::uint64_t count) { return std::to_string(count); }
std::string in_text(double rate_hz) { return fmt::format("{:.3f}", rate_hz); }
std::string in_text(const std::optional<double>& time_s) {
  return time_s ? fmt::format("{:.6f}", *time_s) : "";
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
    devices.push_back(
        {.name = config.name, .kind = config.kind, .provenance = provenance_of(config.link)});
  }
  return devices;
}

std::vector<bus::Device> bus_devices(std::span<const std::unique_ptr<device::Device>> devices) {
  std::vector<bus::Device> all;
  for (const auto& device : devices) {
    all.push_back({.name = std::string(device->name()),
                   .kind = device->options().driver.kind,
                   .provenance = provenance_of(device->options().link)});
  }
  return all;
}

rig_config::Rig rig_of(std::span<const std::unique_ptr<device::Device>> devices,
                       const std::string& name) {
  rig_config::Rig rig;
  rig.name = name;
  for (const auto& device : devices) {
    auto& config = rig.devices.emplace_back();
    config.name = device->name();
    config.kind = device->options().driver.kind;
    config.protocol = device->options().driver.protocol;
    config.description = device->options().driver.description;
    config.link = device->options().link;
    config.rate_hz = device->options().nominal_rate_hz;
    config.address = device->options().driver.address;
    config.stale_after_s = measurement::seconds(device->options().life_cycle.stale_after);
  }
  return rig;
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
  const auto account = device::account_of(device, health, provenance_of(device.options().link));
  bus::DeviceStatus status{.level = level_of(health.state),
                           .name = account.name,
                           .message = account.state,
                           .hardware_id = account.link,
                           .values = {}};
  visit_fields(account, [&](std::string_view key, const auto& value) {
    if (key == "name" || key == "state" || key == "link") return;  // they are in the status itself
    status.values.emplace_back(key, in_text(value));
  });
  return status;
}

}  // namespace drydock::host
