#pragma once

#include <array>
#include <string_view>

#include "drivers/wire/can/can_frame.hpp"

namespace drydock::device {

/// A bit of an error frame (linux/can/error.h) and its meaning for a person.
struct CanErrorBit {
  std::uint32_t bit;
  std::string_view text;
};

/// Byte 1 of an error frame of the class "controller": a full queue, or the error state.
inline std::string_view controller_error_text(std::uint8_t details) {
  constexpr std::array<CanErrorBit, 7> worst_first{{
      {0x20, "error-passive: more than 127 frames sent by this controller failed"},
      {0x10, "error-passive: more than 127 frames were received with errors"},
      {0x01, "receive overflow: the controller lost frames before the kernel read them"},
      {0x02, "transmit overflow: the controller's queue was full"},
      {0x08, "error warning: more than 95 frames sent by this controller failed"},
      {0x04, "error warning: more than 95 frames were received with errors"},
      {0x40, "error-active again"},
  }};
  for (const auto& [bit, text] : worst_first)
    if (details & bit) return text;
  return "controller problem";
}

/// The meaning of an error frame of the controller, for a person. A frame may have several classes
/// (linux/can/error.h); the text names the worst.
inline std::string_view can_error_text(const wire::CanFrame& error_frame) {
  constexpr std::uint32_t controller = 0x004;
  constexpr std::array<CanErrorBit, 9> worst_first{{
      {0x040, "bus-off: the controller has left the bus until it is restarted"},
      {0x020, "no other node acknowledges: cable, terminator or bit rate"},
      {0x010, "transceiver error"},
      {controller, {}},
      {0x080, "bus error"},
      {0x008, "protocol violation: bit rate or wiring"},
      {0x001, "transmit time-out"},
      {0x002, "lost arbitration"},
      {0x100, "controller restarted"},
  }};
  for (const auto& [bit, text] : worst_first)
    if (error_frame.id & bit)
      return bit == controller ? controller_error_text(error_frame.data[1]) : text;
  return "error frame";
}

}  // namespace drydock::device
