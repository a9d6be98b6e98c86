#include "hil/emulate/can/j1939_node.hpp"

#include "drivers/measurement/earlier.hpp"
#include "drivers/wire/j1939/aceinna.hpp"
#include "hil/sensor/random.hpp"

namespace drydock::emulate {
namespace {

void send(const std::optional<wire::CanFrame>& frame, Wire& out) {
  if (frame) out.send(*frame);
}

}  // namespace

std::uint32_t identity_of(const rig_config::DeviceConfig& config) {
  constexpr std::uint32_t identity_bits = 0x1FFFFF;
  constexpr std::uint64_t serial_numbers = 0;  // a unit keeps its number for every seed of a run
  return static_cast<std::uint32_t>(
      sensor::RandomStream(serial_numbers, config.name, "NAME").next() & identity_bits);
}

std::uint32_t identity_in(std::uint64_t name, std::string_view protocol) {
  const bool reversed = protocol == wire::Aceinna::name;
  return (reversed ? wire::aceinna::to_name(name) : wire::j1939::to_name(name)).identity_number;
}

wire::j1939::Name name_for(const rig_config::DeviceConfig& config, std::uint8_t function,
                           std::uint8_t device_class) {
  wire::j1939::Name name;
  name.identity_number = identity_of(config);
  name.function = function;
  name.vehicle_system = device_class;
  name.arbitrary_address_capable = true;
  return name;
}

std::optional<Stamp> J1939Node::deadline() const {
  if (boot_) return boot_;
  return measurement::earlier(std::optional<Stamp>(claim_.deadline()),
                              std::optional<Stamp>(transport_.deadline()));
}

void J1939Node::tick(Stamp now, Wire& out) {
  const auto time = now.time_since_epoch();
  if (boot_ && *boot_ <= now) {
    boot_.reset();
    send(claim_.start(time), out);
  }
  if (claim_.deadline() && *claim_.deadline() <= time) send(claim_.tick(time), out);
  while (transport_.deadline() && *transport_.deadline() <= time) send(transport_.tick(time), out);
}

void J1939Node::receive(const wire::CanFrame& frame, Stamp now, Wire& out) {
  const auto id = wire::j1939::identify(frame);
  if (!id) return;
  send(claim_.receive(frame, now.time_since_epoch()), out);
  receive_packet(*id, frame.payload(), now, out);
}

void J1939Node::rename(std::uint64_t name, Stamp now, Wire& out) {
  send(claim_.rename(name, now.time_since_epoch()), out);
}

void J1939Node::receive_packet(const wire::j1939::Identifier& id, wire::Bytes payload, Stamp now,
                               Wire& out) {
  transport_.set_address(claim_.address());
  const auto got = transport_.receive(id, payload, now.time_since_epoch());
  send(got.reply, out);
  if (!got.message) return;
  const auto command = wire::j1939::decode_commanded_address(got.message->id, got.message->data);
  if (command) send(claim_.obey(*command, now.time_since_epoch()), out);
}

}  // namespace drydock::emulate
