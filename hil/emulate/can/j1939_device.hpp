#pragma once

#include "drivers/wire/j1939/j1939.hpp"
#include "hil/emulate/can/j1939_node.hpp"
#include "hil/emulate/sampling_device.hpp"

namespace drydock::emulate {

/// A sampling device on a J1939 or NMEA 2000 bus. It samples only while it has an address.
class J1939Device : public SamplingDevice {
 public:
  std::optional<Stamp> deadline() const override;
  void tick(Stamp now, Wire& out) override;
  using SamplingDevice::receive;
  void receive(const wire::CanFrame& frame, Stamp now, Wire& out) final;

 protected:
  /// `name` is the value that decides a contention. Takes `preferred` unless the configuration
  /// gives an address.
  J1939Device(const DeviceSetup& setup, std::uint64_t name, std::uint8_t preferred);

  /// Empty: it has none now, and must be silent.
  std::optional<std::uint8_t> own_address() const { return node_.address(); }

  void rename(std::uint64_t name, Stamp now, Wire& out) { node_.rename(name, now, out); }

  /// Receives a frame of the bus while the device has an address.
  virtual void hear(const wire::CanFrame&, Stamp /*now*/, std::uint8_t /*address*/, Wire&) {}

  /// Sends a sample of the truth at `at` from the device's address.
  virtual void report(Stamp at, std::uint8_t address, Wire& out) = 0;

 private:
  void sample(Stamp at, Wire& out) final;

  J1939Node node_;
};

}  // namespace drydock::emulate
