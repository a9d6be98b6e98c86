#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/measurement/measurement.hpp"
#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/codec.hpp"

/// Drivers are sans-I/O: bytes, frames and time come in, measurements and replies go out. A driver
/// never reads a port or a clock. Thus the same driver runs on the bench, in a test without
/// sleeping, and through a mission at full speed.
namespace drydock::device {

using measurement::Measurement;
using measurement::Stamp;

/// Why a driver did not publish a value.
enum class Refusal : std::uint8_t {
  impossible,      ///< it was damaged, or is read wrongly
  of_another,      ///< it is another instance's
  incomplete,      ///< other frames of its sample were lost
  no_measurement,  ///< it is good, but no measurement holds it
};

/// Receives the results of a driver during one call. The arguments are valid only during the call.
class Output {
 public:
  virtual ~Output() = default;
  virtual void publish(const Measurement& measurement) = 0;
  virtual void send(std::span<const std::uint8_t> bytes) = 0;
  virtual void send(const wire::CanFrame& frame) = 0;
  virtual void report(std::string_view) {}  ///< errors that the sensor reports, in words
  /// A value that was not published; it is counted.
  virtual void refuse(std::string_view why, Refusal = Refusal::impossible) { report(why); }
};

/// The common interface of all drivers, for every kind of link.
class Driver {
 public:
  virtual ~Driver() = default;
  virtual void tick(Stamp now, Output& out) = 0;      ///< called at or after deadline()
  virtual std::optional<Stamp> deadline() const = 0;  ///< time of the next tick()
  virtual void restart(Stamp now, Output& out) = 0;   ///< the link was opened (again)
  virtual void finish(Output&) {}  ///< no more comes on this link: what waits comes out
  virtual const wire::StreamCounters& counters() const = 0;  ///< on CAN: payload bytes
  virtual std::size_t held_bytes() const = 0;  ///< bytes_in - bytes_good - bytes_skipped
  virtual void set_provenance(measurement::Provenance provenance) = 0;  ///< the link decides it
};

/// Driver of a sensor on a byte link. `received_at` is the arrival of the last byte in `bytes`.
class ByteDriver : public Driver {
 public:
  virtual void receive(wire::Bytes bytes, Stamp received_at, Output& out) = 0;
  virtual void set_baud(unsigned baud) = 0;  ///< for a line whose rate was searched
};

/// Driver of a sensor on a CAN bus. It selects its own frames from all traffic.
class FrameDriver : public Driver {
 public:
  virtual void receive(const wire::CanFrame& frame, Stamp received_at, Output& out) = 0;
  virtual void set_bitrate(unsigned bitrate) = 0;  ///< bit/s of the bus, as its link knows it
};

}  // namespace drydock::device
