#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace drydock::info {

/// What files have together.
struct TotalInfo {
  std::uint64_t files = 0, size = 0;                    ///< size [bytes]
  std::uint64_t frames = 0;                             ///< of CAN captures
  std::uint64_t messages = 0;                           ///< of recordings
  std::optional<std::chrono::nanoseconds> first, last;  ///< of those with times

  void add(const TotalInfo& other);
};

std::string to_text(const TotalInfo& total);
std::string to_json(const TotalInfo& total);

}  // namespace drydock::info
