#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "drivers/monitor/values/shown_value.hpp"

namespace drydock::monitor {

/// The last frame of one kind on a wire: of one CAN identifier, or of one message of a protocol.
struct ShownFrame {
  std::string name;  ///< "1CFDD323", "NAV-PVT"
  std::uint64_t count = 0;
  double rate_hz = 0;
  std::vector<std::uint8_t> bytes{};
  std::vector<bool> changed{};       ///< by byte, against the frame before
  std::vector<ShownValue> fields{};  ///< as the protocol names them, in its units
};

/// All that came on the wire of one device.
struct ShownWire {
  std::vector<ShownFrame> frames{};
  std::uint64_t not_listed = 0;  ///< kinds of frames beyond the most that are kept
};

}  // namespace drydock::monitor
