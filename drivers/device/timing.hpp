#pragma once

#include <chrono>
#include <cstddef>
#include <optional>

#include "drivers/device/driver_options.hpp"
#include "drivers/measurement/measurement.hpp"
#include "drivers/wire/can/can_frame.hpp"

namespace drydock::device {

using measurement::Origin;
using measurement::Stamp;

/// From arrival back to when a value was true. A sensor's value ages by the protocol's latency
/// until its first bit leaves, then by the time its frame takes on the wire.
class Timing {
 public:
  explicit Timing(const DriverOptions& options);

  /// `after` bytes of the read that ended at `read_at` follow the frame. Where the line has a baud
  /// rate, 10 bits a byte (8N1): received_at = read_at - after bytes,
  /// valid_at = received_at - frame_bytes - latency.
  Origin of_bytes(Stamp read_at, std::size_t frame_bytes, std::size_t after) const;
  /// Where the frame itself says how old its values are, that counts instead of the option.
  Origin of_bytes(Stamp read_at, std::size_t frame_bytes, std::size_t after,
                  std::chrono::nanoseconds latency) const;

  /// `stamp` is the end of the frame, which took its bits on the wire, stuff bits with them.
  Origin of_frame(Stamp stamp, const wire::CanFrame& frame) const;
  Origin of_frame(Stamp stamp, const wire::CanFrame& frame, std::chrono::nanoseconds latency) const;

  std::chrono::nanoseconds line_time(std::size_t bytes) const;  ///< zero without a baud rate
  std::chrono::nanoseconds line_time(const wire::CanFrame& frame) const;  ///< start to end of frame

  void set_baud(unsigned baud) { baud_ = baud; }
  void set_provenance(measurement::Provenance provenance) { provenance_ = provenance; }
  measurement::Provenance provenance() const { return provenance_; }

 private:
  Origin origin(Stamp valid_at, Stamp received_at) const;

  std::optional<unsigned> baud_;
  unsigned bitrate_;
  std::chrono::nanoseconds latency_;
  std::uint16_t device_;
  measurement::Provenance provenance_ = measurement::Provenance::real;
};

}  // namespace drydock::device
