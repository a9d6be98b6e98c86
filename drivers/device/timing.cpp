#include "drivers/device/timing.hpp"

#include <algorithm>

#include "drivers/wire/can/can_bits.hpp"

namespace drydock::device {

namespace {

constexpr std::int64_t ns_per_second = 1'000'000'000;

/// From start of frame to end of frame, ISO 11898-1.
std::int64_t bits_of(const wire::CanFrame& frame) {
  constexpr unsigned intermission_bits = 3;
  return std::int64_t{wire::wire_bits(frame)} - intermission_bits;
}

}  // namespace

Timing::Timing(const DriverOptions& options)
    : rate_(options.baud.value_or(0), options.byte_frame),
      bitrate_(options.bitrate),
      data_bitrate_(options.data_bitrate),
      latency_(options.latency),
      device_(options.device) {}

std::chrono::nanoseconds Timing::line_time(std::size_t bytes) const { return rate_.time_of(bytes); }

Origin Timing::of_bytes(const Arrival& frame, std::chrono::nanoseconds latency) const {
  const Stamp received_at = std::max(frame.read_at - line_time(frame.after), frame.not_before);
  return origin(received_at - line_time(frame.bytes) - latency, received_at);
}

Origin Timing::of_frame(Stamp stamp, const wire::CanFrame& frame) const {
  return of_frame(stamp, frame, latency_);
}

Origin Timing::of_frame(Stamp stamp, const wire::CanFrame& frame,
                        std::chrono::nanoseconds latency) const {
  return origin(stamp - line_time(frame) - latency, stamp);
}

std::chrono::nanoseconds Timing::line_time(const wire::CanFrame& frame) const {
  const std::int64_t fast_bits = data_bitrate_ ? wire::data_phase_bits(frame) : 0;
  const std::int64_t slow_ns = (bits_of(frame) - fast_bits) * ns_per_second / bitrate_;
  return std::chrono::nanoseconds{slow_ns +
                                  (data_bitrate_ ? fast_bits * ns_per_second / *data_bitrate_ : 0)};
}

Origin Timing::origin(Stamp valid_at, Stamp received_at) const {
  return {valid_at, received_at, {}, provenance_, device_};
}

}  // namespace drydock::device
