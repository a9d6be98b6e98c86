#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/wire/can/can_frame.hpp"

/// RAW lines of Yacht Devices' gateways between NMEA 2000 and a network or a serial line (manual of
/// YDWG-02, "RAW"): one frame with a 29-bit identifier each, all numbers in hexadecimal.
///    17:33:21.107 R 19F51323 01 2F 30 70 00 2F 30 70
/// R: received from the bus; T: sent to the bus for a computer. A computer orders that by the same
/// line without time and letter.
namespace drydock::wire::gateway_line {

/// "hh:mm:ss.mmm R 19F51323 01 .. .. .. .. .. .. ..\r\n"
constexpr std::size_t longest = 13 + 2 + 8 + 8 * 3 + 2;

enum class Way : char { received = 'R', sent = 'T' };

/// True for what these lines can carry: a data frame with a 29-bit identifier and at most 8 bytes.
bool carries(const CanFrame& frame);

/// What a gateway says of a frame. Gives the number of characters, 0 for a frame that no line
/// carries. `out` has room for `longest`.
std::size_t encode(const CanFrame& frame, std::chrono::nanoseconds since_midnight, Way way,
                   std::span<std::uint8_t> out);

/// What a computer writes so that the gateway sends the frame.
std::size_t encode_order(const CanFrame& frame, std::span<std::uint8_t> out);

/// The frame of a computer's line, without its end. Empty: it is no order.
std::optional<CanFrame> parse_order(std::string_view line);

}  // namespace drydock::wire::gateway_line
