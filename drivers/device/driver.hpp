#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/measurement/measurement.hpp"
#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/codec.hpp"

/// Drivers are sans-I/O: bytes, frames and time come in, measurements and replies go out.
/// A driver never reads a port or a clock, so the same one runs on the bench, in a test without
/// sleeping, and through a mission at full speed.
namespace drydock::device {

using measurement::Measurement;
using measurement::Stamp;

/// Receives what a driver produces while it handles one call. Nothing is kept after the call.
class Output {
 public:
  virtual ~Output() = default;
  virtual void publish(const Measurement& measurement) = 0;
  virtual void send(std::span<const std::uint8_t> bytes) = 0;
  virtual void send(const wire::CanFrame& frame) = 0;
  virtual void report(std::string_view) {}  ///< trouble that the sensor tells of, in words
};

/// What every driver has, whatever its sensor is wired to.
class Driver {
 public:
  virtual ~Driver() = default;
  virtual void tick(Stamp now, Output& out) = 0;             ///< called at or after deadline()
  virtual std::optional<Stamp> deadline() const = 0;         ///< when it wants tick() next
  virtual void restart(Stamp now, Output& out) = 0;          ///< the link was opened (again)
  virtual const wire::StreamCounters& counters() const = 0;  ///< on CAN: payload bytes
  virtual std::size_t held_bytes() const = 0;  ///< bytes_in - bytes_good - bytes_skipped
  virtual void set_provenance(measurement::Provenance provenance) = 0;  ///< told by the link
};

/// Driver of a sensor on a byte link. `received_at` is when the last byte of `bytes` arrived.
class ByteDriver : public Driver {
 public:
  virtual void receive(wire::Bytes bytes, Stamp received_at, Output& out) = 0;
  virtual void set_baud(unsigned baud) = 0;  ///< of a line whose rate was found
};

/// Driver of a sensor on a CAN bus; it picks its own frames out of all traffic.
class FrameDriver : public Driver {
 public:
  virtual void receive(const wire::CanFrame& frame, Stamp received_at, Output& out) = 0;
};

}  // namespace drydock::device
