#pragma once

#include <algorithm>
#include <optional>
#include <string_view>

#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "drivers/wire/ubx/ubx.hpp"

namespace drydock::wire {

/// Cuts a line with alternating UBX and NMEA 0183 into frames. An RTCM 3 frame is a frame without a
/// message. All other bytes are skipped.
Scan scan_ubx_or_nmea(Bytes bytes);

/// A receiver's port that carries both protocols.
struct UbxNmea {
  static constexpr std::string_view name = "ubx+nmea0183";
  static constexpr std::size_t max_frame = std::max(Ubx::max_frame, Nmea0183::max_frame);
  using Message = decltype(joined(UbxMessages{}, Nmea0183Messages{}))::Variant;

  static Scan scan(Bytes bytes) { return scan_ubx_or_nmea(bytes); }
  static std::optional<Message> decode(Bytes frame);
};

}  // namespace drydock::wire
