#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

namespace drydock::device {

/// Settings for a u-blox receiver. What is not named is left unchanged.
struct UbloxSettings {
  struct Rate {
    std::uint16_t class_and_id = 0;  ///< one of wire::ubx::message_names
    std::uint8_t epochs = 0;         ///< the message comes each so many epochs; 0: never
  };
  std::optional<std::chrono::milliseconds> period;  ///< between two measurements, 25 ms to 60 s
  std::vector<Rate> messages;                       ///< on the port that the driver is at

  bool any() const { return period || !messages.empty(); }
};

}  // namespace drydock::device
