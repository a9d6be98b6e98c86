#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/wire/can/can_frame.hpp"

/// Log lines of can-utils' `candump -L` and `-l`: `(1436509052.249713) vcan0 044#2A366C2BBA`. An
/// identifier of 3 hex digits has 11 bits. One of 8 digits has 29 bits or, with 0x20000000, belongs
/// to an error frame. `#R4` is a remote frame, `##1...` CAN FD with its flags. ` R` or ` T` may
/// follow.
namespace drydock::wire::candump {

enum class Direction : std::uint8_t { unknown, received, transmitted };

constexpr std::size_t longest_line = 288;  ///< 64 bytes of CAN FD, with dots between and a line end

struct Line {
  std::chrono::nanoseconds time{};  ///< UTC since 1970 in most logs, in some since the start
  std::string_view interface;       ///< points into the text given to parse_line
  CanFrame frame;
  Direction direction = Direction::unknown;
};

/// `text` is a line without its end. Empty if it cannot be parsed.
std::optional<Line> parse_line(std::string_view text);

/// Parses 3 or 8 hex digits into identifier and kind of the frame. False if they are invalid.
bool parse_identifier(std::string_view digits, CanFrame& frame);

/// Writes the line with its LF as `candump -L` does, with microseconds. Returns its size.
std::size_t encode(const Line& line, std::span<std::uint8_t> out);

}  // namespace drydock::wire::candump
