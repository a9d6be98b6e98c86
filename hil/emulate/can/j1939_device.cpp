#include "hil/emulate/can/j1939_device.hpp"

#include "drivers/measurement/earlier.hpp"

namespace drydock::emulate {
namespace {

void send(const std::optional<wire::CanFrame>& frame, Wire& out) {
  if (frame) out.send(*frame);
}

}  // namespace

wire::j1939::Name name_for(const DeviceConfig& config, std::uint8_t function,
                           std::uint8_t device_class) {
  constexpr std::uint32_t identity_bits = 0x1FFFFF;
  constexpr std::uint64_t serial_numbers = 0;  // a unit keeps its number for every seed of a run
  wire::j1939::Name name;
  name.identity_number = static_cast<std::uint32_t>(
      sensor::RandomStream(serial_numbers, config.name, "NAME").next() & identity_bits);
  name.function = function;
  name.vehicle_system = device_class;
  name.arbitrary_address_capable = true;
  return name;
}

J1939Device::J1939Device(const DeviceSetup& setup, std::uint64_t name, std::uint8_t preferred)
    : SamplingDevice(setup),
      claim_(name, setup.config.address != 0 ? static_cast<std::uint8_t>(setup.config.address)
                                             : preferred),
      boot_(setup.boot) {}

std::optional<Stamp> J1939Device::deadline() const {
  if (boot_) return boot_;
  auto next = SamplingDevice::deadline();
  for (const auto& due : {claim_.deadline(), transport_.deadline()})
    next = measurement::earlier(next, std::optional<Stamp>(due));
  return next;
}

void J1939Device::tick(Stamp now, Wire& out) {
  if (boot_ && *boot_ <= now) {
    boot_.reset();
    send(claim_.start(now.time_since_epoch()), out);
  }
  if (claim_.deadline() && *claim_.deadline() <= now.time_since_epoch()) {
    send(claim_.tick(now.time_since_epoch()), out);
  }
  while (transport_.deadline() && *transport_.deadline() <= now.time_since_epoch()) {
    send(transport_.tick(now.time_since_epoch()), out);
  }
  SamplingDevice::tick(now, out);
}

void J1939Device::receive(const wire::CanFrame& frame, Stamp now, Wire& out) {
  const auto id = wire::j1939::identify(frame);
  if (!id) return;
  send(claim_.receive(frame, now.time_since_epoch()), out);
  if (const auto address = claim_.address()) hear(frame, *address, out);
  receive_packet(*id, frame.payload(), now, out);
}

void J1939Device::receive_packet(const wire::j1939::Identifier& id, wire::Bytes payload, Stamp now,
                                 Wire& out) {
  transport_.set_address(claim_.address());
  const auto got = transport_.receive(id, payload, now.time_since_epoch());
  send(got.reply, out);
  if (!got.message) return;
  const auto command = wire::j1939::decode_commanded_address(got.message->id, got.message->data);
  if (command) send(claim_.obey(*command, now.time_since_epoch()), out);
}

void J1939Device::sample(Stamp at, Wire& out) {
  if (const auto address = claim_.address()) report(at, *address, out);
}

}  // namespace drydock::emulate
