#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/wire/can/can_frame.hpp"

/// Log lines of can-utils' `candump -L` and `-l`: `(1436509052.249713) vcan0 044#2A366C2BBA`.
/// 3 hex digits are an 11-bit, 8 a 29-bit identifier or, with 0x20000000, an error frame;
/// `#R4` a remote frame, `##1...` CAN FD with its flags; ` R` or ` T` may follow.
namespace drydock::wire::candump {

enum class Direction : std::uint8_t { unknown, received, transmitted };

constexpr std::size_t longest_line = 288;  ///< with CAN FD's 64 bytes, dots between and an end

struct Line {
  std::chrono::nanoseconds time{};  ///< UTC since 1970 in most logs, in some since the start
  std::string_view interface;       ///< points into the text given to parse_line
  CanFrame frame;
  Direction direction = Direction::unknown;
};

/// A line without its end; empty if it is none.
std::optional<Line> parse_line(std::string_view text);

/// 3 or 8 hex digits into identifier and kind of the frame; false if they are none.
bool parse_identifier(std::string_view digits, CanFrame& frame);

/// Writes the line with its LF as `candump -L` does, microseconds; returns its size.
std::size_t encode(const Line& line, std::span<std::uint8_t> out);

}  // namespace drydock::wire::candump
