#include "drivers/monitor/told_by_bus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "drivers/host/rig_bus.hpp"
#include "drivers/host/told_status.hpp"
#include "drivers/text/printable.hpp"

namespace drydock::monitor {
namespace {

bool has_emulated_devices(const rig_config::Rig& rig) {
  return std::ranges::any_of(rig.devices, [](const rig_config::DeviceConfig& device) {
    return host::provenance_of(device.link) == measurement::Provenance::emulated;
  });
}

bus::SubscriberOptions diagnostics_alone() {
  bus::SubscriberOptions options;
  options.diagnostics = true;
  return options;
}

}  // namespace

struct ToldByBus::Reader {
  explicit Reader(const rig_config::Rig& rig)
      : participant(static_cast<std::uint32_t>(rig.dds_domain), rig.dds_interface) {}
  bus::Participant participant;
  bus::Subscriber subscriber{participant, {}, diagnostics_alone()};
};

ToldByBus::ToldByBus(const rig_config::Rig& rig) {
  if (rig.file.empty() || !has_emulated_devices(rig)) return;
  try {
    reader_ = std::make_unique<Reader>(rig);
  } catch (const bus::Error& error) {
    fmt::print(stderr, "monitor: what emulated devices were told is not shown: {}\n", error.what());
  }
}

ToldByBus::~ToldByBus() = default;

void ToldByBus::poll() {
  if (reader_) reader_->subscriber.take(*this);
}

void ToldByBus::receive(const bus::DeviceStatus& status) {
  const auto told = host::told_of(status);
  constexpr std::size_t most_devices = 1000;
  if (told && (told_.size() < most_devices || told_.contains(told->device)))
    told_[told->device] = text::printable(told->what);
}

std::string ToldByBus::of(const std::string& device) const {
  const auto told = told_.find(device);
  return told == told_.end() ? std::string() : told->second;
}

}  // namespace drydock::monitor
