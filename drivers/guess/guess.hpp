#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "drivers/wire/codec.hpp"

namespace drydock::guess {

/// A first description (docs/sensors/described.md) of a line that nobody knows, from what it said:
/// sentences with their columns, lines, or binary frames with their sync, their length, their
/// checksum, their kinds, constant and counting bytes and what looks like numbers. It only guesses,
/// and its text says so. Empty: it finds nothing that repeats.
std::string guess_description(wire::Bytes capture);

/// A description of lines, and how many of them it describes.
struct LinesGuess {
  std::string text;
  std::size_t lines = 0;
};

// The ways. Lines are without their line ends.
std::string guess_text(wire::Bytes capture);
LinesGuess guess_lines(const std::vector<std::string_view>& lines);
LinesGuess guess_fixed_lines(const std::vector<std::string_view>& lines);
std::string guess_hex_lines(const std::vector<std::string_view>& lines);
std::string guess_binary(wire::Bytes capture);

}  // namespace drydock::guess
