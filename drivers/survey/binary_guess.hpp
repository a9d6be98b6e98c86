#pragma once

#include <optional>

#include "drivers/survey/guess_checksum.hpp"

namespace drydock::survey {

/// An integer of a frame that says how long it is.
struct LengthField {
  std::size_t at = 0, size = 1;
  bool big_endian = false;
  std::size_t plus = 0;  ///< bytes that it does not count
};

/// Frames that begin alike.
struct BinaryGuess {
  std::size_t sync = 2;               ///< bytes with which each frame begins
  std::optional<LengthField> length;  ///< empty: all have the length of the first
  std::optional<Sum> sum;
  Frames frames;

  std::size_t bytes() const;  ///< in all frames
  bool has_one_length() const;
};

/// Where the byte behind a frame, as long as a field of it says, begins with the same sync again.
/// The guess that most bytes follow; with a checksum, before those without. Empty: none is
/// plausible.
std::optional<BinaryGuess> guess_lengths(wire::Bytes capture);

/// Frames of one length, by the distance at which bytes repeat.
std::optional<BinaryGuess> guess_period(wire::Bytes capture);

/// As a description: the messages that the frames are, and their fields.
std::string binary_text(const BinaryGuess& guess);

}  // namespace drydock::survey
