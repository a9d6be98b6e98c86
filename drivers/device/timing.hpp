#pragma once

#include <chrono>
#include <cstddef>
#include <optional>

#include "drivers/device/arrival.hpp"
#include "drivers/device/driver_options.hpp"
#include "drivers/measurement/measurement.hpp"
#include "drivers/wire/can/can_frame.hpp"

namespace drydock::device {

using measurement::Origin;
/// Computes from an arrival the time at which a value was true. The value ages by the protocol's
/// latency until its first bit is sent, and then by the time of its frame on the wire.
class Timing {
 public:
  explicit Timing(const DriverOptions& options);

  /// If the line has a baud rate, a byte takes the bits of its frame (10 for 8N1): received_at =
  /// read_at - after bytes, and not before the frame in front of it; valid_at = received_at - bytes
  /// of the frame - latency.
  Origin of_bytes(const Arrival& frame) const { return of_bytes(frame, latency_); }
  /// If the frame gives the age of its values, `latency` replaces the option.
  Origin of_bytes(const Arrival& frame, std::chrono::nanoseconds latency) const;

  /// `stamp` is the end of the frame. The frame took all its bits on the wire, including stuff
  /// bits.
  Origin of_frame(Stamp stamp, const wire::CanFrame& frame) const;
  Origin of_frame(Stamp stamp, const wire::CanFrame& frame, std::chrono::nanoseconds latency) const;

  std::chrono::nanoseconds line_time(std::size_t bytes) const;  ///< zero without a baud rate
  std::chrono::nanoseconds line_time(const wire::CanFrame& frame) const;  ///< start to end of frame

  const wire::LineRate& rate() const { return rate_; }
  void set_baud(unsigned baud) { rate_.baud = baud; }
  void set_bitrate(unsigned bitrate) { bitrate_ = bitrate; }
  void set_provenance(measurement::Provenance provenance) { provenance_ = provenance; }
  measurement::Provenance provenance() const { return provenance_; }

 private:
  Origin origin(Stamp valid_at, Stamp received_at) const;

  wire::LineRate rate_;
  unsigned bitrate_;
  std::optional<unsigned> data_bitrate_;
  std::chrono::nanoseconds latency_;
  std::uint16_t device_;
  measurement::Provenance provenance_ = measurement::Provenance::real;
};

}  // namespace drydock::device
