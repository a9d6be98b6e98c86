#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "drivers/wire/can/can_frame.hpp"

namespace drydock::device {

/// The meaning of an error frame of the controller, for a person. A frame may have several classes
/// (linux/can/error.h); the text names the worst.
inline std::string_view can_error_text(const wire::CanFrame& error_frame) {
  using Class = std::pair<std::uint32_t, std::string_view>;
  constexpr std::array<Class, 9> worst_first{{
      {0x040, "bus-off: the controller has left the bus until it is restarted"},
      {0x020, "no other node acknowledges: cable, terminator or bit rate"},
      {0x010, "transceiver error"},
      {0x004, "controller problem: queue overflow or error level"},
      {0x080, "bus error"},
      {0x008, "protocol violation: bit rate or wiring"},
      {0x001, "transmit time-out"},
      {0x002, "lost arbitration"},
      {0x100, "controller restarted"},
  }};
  for (const auto& [bit, text] : worst_first) {
    if (error_frame.id & bit) return text;
  }
  return "error frame";
}

}  // namespace drydock::device
