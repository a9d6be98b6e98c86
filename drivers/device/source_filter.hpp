#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::device {

/// Which sender on a bus is our sensor: the configured address or, without one, the first heard.
/// That one stays ours until silent for 10 s, so two sensors are never mixed. A sensor whose NAME
/// was heard is followed to whatever address it claims, and not mistaken for the node that took its
/// address from it (SAE J1939-81).
class SourceFilter {
 public:
  explicit SourceFilter(std::uint8_t configured) : configured_(configured) {
    if (configured != 0) ours_ = configured;
  }

  bool accepts(std::uint8_t source, measurement::Stamp now) {
    const bool any = configured_ == 0 && !name_;
    const bool forgotten = any && ours_ && now - heard_at_ > std::chrono::seconds{10};
    if (any && (!ours_ || forgotten)) ours_ = source;
    if (ours_ != source) return false;
    heard_at_ = now;
    return true;
  }

  /// PGN 60928. The first NAME claimed at our sensor's address is its own.
  void claimed(std::uint8_t source, std::uint64_t name) {
    if (name_ == name) {
      ours_ = source;
    } else if (ours_ == source) {
      if (name_)
        ours_.reset();
      else
        name_ = name;
    }
  }

  std::optional<std::uint8_t> source() const { return ours_; }

 private:
  std::uint8_t configured_;
  std::optional<std::uint8_t> ours_;  ///< its address now; empty: not heard, or robbed of it
  std::optional<std::uint64_t> name_;
  measurement::Stamp heard_at_{};
};

}  // namespace drydock::device
