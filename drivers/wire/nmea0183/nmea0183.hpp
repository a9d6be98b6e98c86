#pragma once

#include <optional>
#include <string_view>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/message_list.hpp"
#include "drivers/wire/nmea0183/nmea0183_gnss.hpp"
#include "drivers/wire/nmea0183/nmea0183_heading.hpp"
#include "drivers/wire/nmea0183/nmea0183_position.hpp"
#include "drivers/wire/nmea0183/nmea0183_speed.hpp"

namespace drydock::wire {

using Nmea0183Messages =
    MessageList<Gga, Rmc, Gsv, Gsa, Vtg, Zda, Gns, Gll, Gst, Hdt, Ths, Hdg, Hdm, Vhw, Vbw, Vlw>;

/// NMEA 0183, all talkers. A frame goes from `$` to the checksum and its line end (CR LF, LF or
/// CR); a TAG block in front of it (NMEA 0183 4.00, `\s:GP0001,c:1704067170*hh\`) is part of it. A
/// sentence that begins with `!`, as those of AIS do, is a frame that gives no message. A sentence
/// without a checksum is not a frame. A `$` inside a sentence starts a new one.
struct Nmea0183 {
  static constexpr std::string_view name = "nmea0183";
  /// The standard has 82. Receivers with many satellites and sentences of vendors exceed it.
  static constexpr std::size_t max_frame = 1024;
  using Message = Nmea0183Messages::Variant;

  static Scan scan(Bytes bytes);
  static std::optional<Message> decode(Bytes frame);
};

}  // namespace drydock::wire
