#include <fmt/format.h>

#include <algorithm>

#include "drivers/wire/protocols.hpp"
#include "rig_config/fault_quantity.hpp"
#include "rig_config/fault_vocabulary.hpp"
#include "rig_config/typed/build.hpp"

namespace drydock::rig_config {

namespace {

using enum FaultNeed;

/// A proxy may not know which protocol passes through it: then the device can do nothing special.
const wire::Protocol& facts_of(const DeviceConfig& device) {
  static constexpr wire::Protocol unknown;
  const wire::Protocol* known = protocol_of(device);
  return known ? *known : unknown;
}

bool on_can(const DeviceConfig& device) {
  return facts_of(device).travels == wire::Travels::as_frames;
}

bool on_serial_line(const DeviceConfig& device) {
  return device.link.starts_with("pty:") || device.link.starts_with("serial:");
}

bool tells_baud(const DeviceConfig& device) {
  return device.link.find("?baud=") != std::string::npos ||
         device.link.find("&baud=") != std::string::npos;
}

/// True if the messages of the device contain a time of its own clock.
bool tells_time(const DeviceConfig& device) {
  const wire::DeviceClock clock = facts_of(device).clock;
  return clock == wire::DeviceClock::yes ||
         (clock == wire::DeviceClock::of_receiver && device.kind == DeviceKind::gnss);
}

bool has_noise(const DeviceConfig& device) {
  const auto any = [](const SensorErrors& errors) {
    return std::ranges::any_of(errors.noise, [](double x) { return x != 0; }) ||
           std::ranges::any_of(errors.noise_density, [](double x) { return x != 0; });
  };
  return any(device.emulate.primary) || any(device.emulate.secondary);
}

/// True for faults that only the device at the far end of the wire can produce.
bool needs_emulation(const FaultWord& word) {
  return word.layer == FaultLayer::measurement || word.layer == FaultLayer::environment ||
         word.facts.emulated_only;
}

std::optional<std::string> of_the_wire(FaultNeed need, const DeviceConfig& device) {
  switch (need) {
    case byte_stream:
      if (on_can(device))
        return "a CAN frame tells no length in its bytes; allowed: flip, truncate";
      break;
    case checksum:
      if (facts_of(device).checksum.empty())
        return "its protocol has no checksum of its own; allowed: flip, truncate";
      break;
    case port:
      if (on_can(device)) return "a node on a bus is not a port; allowed: hang, off, bus-off";
      if (device.link.starts_with("udp:"))
        return "datagrams have no connection that could be lost; allowed: hang, off";
      break;
    case baud_rate:
      if (!on_serial_line(device)) return "only a serial line has a baud rate (pty, serial)";
      if (!tells_baud(device)) return "its link names no baud rate (?baud=)";
      break;
    case can_bus:
      if (!on_can(device)) return "only a CAN bus has that";
      break;
    case settings:
      if (facts_of(device).settings != wire::Settings::refusable)
        return "nothing is set on it that it could refuse";
      break;
    case j1939:
      if (facts_of(device).network != wire::Network::j1939)
        return "only J1939 and NMEA 2000 nodes claim addresses";
      break;
    default: break;
  }
  return {};
}

std::optional<std::string> of_the_sensor(FaultNeed need, const DeviceConfig& device) {
  switch (need) {
    case noise:
      if (!has_noise(device)) return "it is emulated without noise; give it some under emulate";
      break;
    case own_clock:
      if (!tells_time(device)) return "its messages have no time of its own clock";
      break;
    case sea_bed:
      if (device.kind != DeviceKind::dvl) return "only a dvl hears the sea bed";
      break;
    case heat:
      if (!facts_of(device).tells_heat) return "only a Water Linked dvl tells its heat";
      break;
    case satellites:
      if (device.kind != DeviceKind::gnss) return "only a gnss receiver has satellites";
      break;
    default: break;
  }
  return {};
}

/// A proxy may not know which protocol passes through it. Then it has no message faults.
std::optional<std::string> of_unknown_messages(const FaultWord& word, const DeviceConfig& device) {
  if (!device.protocol.empty() || word.layer != FaultLayer::message) return {};
  return "its messages are not known without a protocol (--protocol)";
}

/// The kind of sensor must measure the quantity that the fault names.
std::optional<std::string> of_the_quantity(const FaultConfig& fault, const DeviceConfig& device) {
  if (fault.quantity.empty()) return {};
  std::string measured;
  for (const FaultQuantity& quantity : fault_quantities) {
    if (quantity.kind != device.kind) continue;
    if (quantity.key == fault.quantity) return {};
    measured += (measured.empty() ? "" : " and ") + std::string(quantity.key);
  }
  return fmt::format("a {} measures {}, not {}", to_string(device.kind), measured, fault.quantity);
}

std::string_view name_of(FaultTarget target) {
  return target == FaultTarget::replayed ? "a recording" : "a real device";
}

}  // namespace

std::optional<std::string> refusal(const FaultConfig& fault, const DeviceConfig& device,
                                   FaultTarget target) {
  const FaultWord& word = word_of(fault.kind);
  std::optional<std::string> why = of_unknown_messages(word, device);
  if (!why) why = of_the_wire(word.facts.needs, device);
  if (!why && target != FaultTarget::emulated && needs_emulation(word))
    why = fmt::format("behind the wire is {}: only an emulated device can be made to",
                      name_of(target));
  if (!why && target == FaultTarget::emulated) why = of_the_sensor(word.facts.needs, device);
  if (!why) why = of_the_quantity(fault, device);
  if (!why) return {};
  return fmt::format("{} \"{}\" ({}) cannot have the fault \"{}\": {}", to_string(device.kind),
                     device.name, device.protocol, word.name, *why);
}

}  // namespace drydock::rig_config
