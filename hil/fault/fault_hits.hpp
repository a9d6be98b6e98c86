#pragma once

#include <array>
#include <cstdint>

#include "rig_config/fault.hpp"

namespace drydock::fault {

/// Counts the hits of each kind of fault: messages, or occurrences for unplug, eof and bus-off.
class FaultHits {
 public:
  std::uint64_t& operator[](rig_config::FaultKind kind) {
    return hits_.at(static_cast<std::size_t>(kind));
  }
  std::uint64_t operator[](rig_config::FaultKind kind) const {
    return hits_.at(static_cast<std::size_t>(kind));
  }
  FaultHits& operator+=(const FaultHits& other) {
    for (std::size_t i = 0; i < hits_.size(); ++i) hits_.at(i) += other.hits_.at(i);
    return *this;
  }
  bool none() const { return hits_ == decltype(hits_){}; }

 private:
  std::array<std::uint64_t, 256> hits_{};  ///< indexed by FaultKind
};

}  // namespace drydock::fault
