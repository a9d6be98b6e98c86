#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hil/emulate/emulated_device.hpp"

namespace drydock::emulate {

/// How often each PGN of a device's samples is sent, and with which priority, as another node has
/// set it by a group function. A device sends a PGN with the first sample at or after its time; it
/// cannot send more often than it measures.
class Nmea2000Intervals {
 public:
  enum class Verdict : std::uint8_t { done, too_low, not_supported };

  /// `period`: of the samples.
  Nmea2000Intervals(std::span<const std::uint32_t> pgns, std::chrono::nanoseconds period);

  /// `interval`: empty as delivered, 0 never. `offset`: from `now` to the first one; empty: at
  /// once.
  Verdict set(std::uint32_t pgn, std::optional<std::chrono::milliseconds> interval,
              std::optional<std::chrono::milliseconds> offset, Stamp now);
  /// Empty: as delivered. False: the device does not send this PGN by itself.
  bool set_priority(std::uint32_t pgn, std::optional<std::uint8_t> priority);

  /// Whether frames of a PGN go with the sample taken at `at`.
  bool passes(std::uint32_t pgn, Stamp at);
  std::optional<std::uint8_t> priority(std::uint32_t pgn) const;

 private:
  struct Sent {
    std::uint32_t pgn = 0;
    std::optional<Stamp> last;           ///< when the device has had it to send
    std::chrono::nanoseconds natural{};  ///< as delivered, that of the samples until it is known
    bool is_known = false;
    std::optional<std::chrono::milliseconds> interval;
    Stamp next{};
    bool passes = true;
    std::optional<std::uint8_t> priority;
  };
  Sent* find(std::uint32_t pgn);

  std::vector<Sent> sent_;
};

/// Passes on what a device sends with one sample, as the intervals have it.
class IntervalWire final : public Wire {
 public:
  IntervalWire(Wire& out, Nmea2000Intervals& intervals, Stamp at)
      : out_(out), intervals_(intervals), at_(at) {}
  void send(wire::Bytes bytes) override { out_.send(bytes); }
  void send(const wire::CanFrame& frame) override;
  void tell(std::string_view what) override { out_.tell(what); }

 private:
  Wire& out_;
  Nmea2000Intervals& intervals_;
  Stamp at_;
};

}  // namespace drydock::emulate
