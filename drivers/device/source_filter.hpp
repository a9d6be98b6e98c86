#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::device {

/// Which sender on a bus is our sensor: the configured address or, without one, the first heard.
/// It stays ours until silent for 10 s, so two sensors are never mixed, and one that changed its
/// address is found again.
class SourceFilter {
 public:
  explicit SourceFilter(std::uint8_t configured) : configured_(configured) {}

  bool accepts(std::uint8_t source, measurement::Stamp now) {
    if (configured_ != 0) return source == configured_;
    const bool forgotten = heard_ && now - heard_at_ > std::chrono::seconds{10};
    if (!heard_ || forgotten) heard_ = source;
    if (*heard_ != source) return false;
    heard_at_ = now;
    return true;
  }

  std::optional<std::uint8_t> source() const {
    return configured_ != 0 ? std::optional{configured_} : heard_;
  }

 private:
  std::uint8_t configured_;
  std::optional<std::uint8_t> heard_;
  measurement::Stamp heard_at_{};
};

}  // namespace drydock::device
