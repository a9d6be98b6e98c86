#pragma once

#include <string_view>

#include "drivers/wire/j1939/j1939.hpp"
#include "drivers/wire/j1939/j1939_address_claim.hpp"
#include "drivers/wire/j1939/j1939_transport_receiver.hpp"
#include "hil/emulate/emulated_device.hpp"
#include "rig_config/rig.hpp"

namespace drydock::emulate {

/// The identity number in the NAME of a device: it depends on the device's name in the rig.
std::uint32_t identity_of(const rig_config::DeviceConfig& config);
/// The identity number of a NAME that was claimed by a device of a protocol.
std::uint32_t identity_in(std::uint64_t name, std::string_view protocol);

/// A NAME with the identity number of the device.
wire::j1939::Name name_for(const rig_config::DeviceConfig& config, std::uint8_t function,
                           std::uint8_t device_class);

/// The network side of an emulated device on a J1939 or NMEA 2000 bus. It claims an address at
/// boot, defends it, answers requests for it, and takes another on command (PGN 65240).
class J1939Node {
 public:
  J1939Node(std::uint64_t name, std::uint8_t preferred, Stamp boot)
      : claim_(name, preferred), boot_(boot) {}

  bool is_booting() const { return boot_.has_value(); }
  std::optional<Stamp> deadline() const;
  void tick(Stamp now, Wire& out);
  void receive(const wire::CanFrame& frame, Stamp now, Wire& out);

  /// Claims its address under another NAME.
  void rename(std::uint64_t name, Stamp now, Wire& out);

  /// Empty: it has none now, and must be silent.
  std::optional<std::uint8_t> address() const { return claim_.address(); }

 private:
  void receive_packet(const wire::j1939::Identifier& id, wire::Bytes payload, Stamp now, Wire& out);

  wire::j1939::TransportReceiver transport_;
  wire::j1939::AddressClaim claim_;
  std::optional<Stamp> boot_;  ///< empty after booting
};

}  // namespace drydock::emulate
