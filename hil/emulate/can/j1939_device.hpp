#pragma once

#include "drivers/wire/j1939/j1939.hpp"
#include "drivers/wire/j1939/j1939_address_claim.hpp"
#include "drivers/wire/j1939/j1939_transport_receiver.hpp"
#include "hil/emulate/sampling_device.hpp"

namespace drydock::emulate {

/// A NAME whose identity number depends on the device's name in the rig.
wire::j1939::Name name_for(const DeviceConfig& config, std::uint8_t function,
                           std::uint8_t device_class);

/// A sampling device on a J1939 or NMEA 2000 bus. It claims an address at boot, defends it, answers
/// requests for it, takes another on command (PGN 65240), and samples only while it has one.
class J1939Device : public SamplingDevice {
 public:
  std::optional<Stamp> deadline() const final;
  void tick(Stamp now, Wire& out) final;
  using SamplingDevice::receive;
  void receive(const wire::CanFrame& frame, Stamp now, Wire& out) final;

 protected:
  /// `name` is the value that decides a contention. Takes `preferred` unless the configuration
  /// gives an address.
  J1939Device(const DeviceSetup& setup, std::uint64_t name, std::uint8_t preferred);

  /// Receives a frame of the bus while the device has an address.
  virtual void hear(const wire::CanFrame&, std::uint8_t /*address*/, Wire&) {}

  /// Sends a sample of the truth at `at` from the device's address.
  virtual void report(Stamp at, std::uint8_t address, Wire& out) = 0;

 private:
  void sample(Stamp at, Wire& out) final;
  void receive_packet(const wire::j1939::Identifier& id, wire::Bytes payload, Stamp now, Wire& out);

  wire::j1939::TransportReceiver transport_;
  wire::j1939::AddressClaim claim_;
  std::optional<Stamp> boot_;  ///< empty after booting
};

}  // namespace drydock::emulate
