#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/measurement/measurement.hpp"
#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/codec.hpp"

/// The other end of the wire: a device that turns the truth into the bytes of a real device. It
/// does no I/O, like the drivers, so the same emulated device runs on a pty, on a CAN bus and in
/// lockstep.
namespace drydock::emulate {

using measurement::Stamp;

/// One of the clients of a device whose link serves several.
using Client = std::uint64_t;
inline constexpr Client every_client = 0;

/// Takes what a device sends. The line after it paces: bytes leave at the baud rate, frames at the
/// bus's bit rate, in the order in which they were sent.
class Wire {
 public:
  virtual ~Wire() = default;
  virtual void send(wire::Bytes bytes) = 0;
  virtual void send(const wire::CanFrame& frame) = 0;
  /// Only this client hears it, if the link can tell them apart.
  virtual void send_to(Client, wire::Bytes bytes) { send(bytes); }
  /// During EmulatedDevice::receive(): who says it.
  virtual Client speaker() const { return every_client; }

  /// Bit/s of the line as the rig has it; 0: it has none.
  virtual unsigned line_baud() const { return 0; }
  /// The device speaks and listens at this rate from now on; what it sent before leaves at the old
  /// one. Without effect on a link without a rate.
  virtual void set_baud(unsigned) {}
  /// What a host has told the device, in words, for the person at the bench.
  virtual void tell(std::string_view) {}

  /// Removes the port until plug(). For a node of a bus: cuts the drivers off from the bus.
  virtual void unplug() {}
  virtual void plug() {}
};

class EmulatedDevice {
 public:
  virtual ~EmulatedDevice() = default;
  virtual std::optional<Stamp> deadline() const = 0;  ///< the next time at which it samples or
                                                      ///< answers
  virtual void tick(Stamp now, Wire& out) = 0;
  virtual void receive(wire::Bytes bytes, Stamp now, Wire& out) = 0;  ///< from the driver
  virtual void receive(const wire::CanFrame& frame, Stamp now, Wire& out) = 0;
  /// While it sends a sample: when the sample was taken. Empty: the message belongs to no sample.
  virtual std::optional<Stamp> sampled_at() const { return {}; }
  /// While it sends: which one of several devices on its line. One device is 0.
  virtual std::size_t sender() const { return 0; }
};

/// A message or frame on its way over the wire, for a comparison with the drivers' times.
struct Passage {
  std::optional<Stamp> sampled_at;  ///< EmulatedDevice::sampled_at() when it was sent
  Stamp sent_at{};                  ///< handed to the line, which may be busy
  Stamp began_at{};                 ///< its first bit leaves
  Stamp ended_at{};                 ///< its last bit has left
  std::size_t sender = 0;           ///< EmulatedDevice::sender() when it was sent over a line
};

}  // namespace drydock::emulate
