#include "hil/emulate/can/j1939_device.hpp"

#include "drivers/measurement/earlier.hpp"

namespace drydock::emulate {

J1939Device::J1939Device(const DeviceSetup& setup, std::uint64_t name, std::uint8_t preferred)
    : SamplingDevice(setup),
      node_(name,
            setup.config.address != 0 ? static_cast<std::uint8_t>(setup.config.address) : preferred,
            setup.boot) {}

std::optional<Stamp> J1939Device::deadline() const {
  if (node_.is_booting()) return node_.deadline();
  return measurement::earlier(SamplingDevice::deadline(), node_.deadline());
}

void J1939Device::tick(Stamp now, Wire& out) {
  node_.tick(now, out);
  SamplingDevice::tick(now, out);
}

void J1939Device::receive(const wire::CanFrame& frame, Stamp now, Wire& out) {
  if (!wire::j1939::identify(frame)) return;
  node_.receive(frame, now, out);
  if (const auto address = node_.address()) hear(frame, now, *address, out);
}

void J1939Device::sample(Stamp at, Wire& out) {
  if (const auto address = node_.address()) report(at, *address, out);
}

}  // namespace drydock::emulate
