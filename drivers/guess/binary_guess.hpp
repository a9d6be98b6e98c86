#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "drivers/guess/guess_checksum.hpp"
#include "drivers/wire/described/stuffing.hpp"

namespace drydock::guess {

/// An integer of a frame that says how long it is.
struct LengthField {
  std::size_t at = 0, size = 1;
  bool big_endian = false;
  std::size_t plus = 0;  ///< bytes that it does not count
};

/// Frames that begin alike.
struct BinaryGuess {
  std::size_t sync = 2;               ///< bytes with which each frame begins
  std::optional<LengthField> length;  ///< empty: all of one identifier have one length
  std::optional<Sum> sum;
  Frames frames;
  wire::described::Stuffing stuffing = wire::described::Stuffing::none;
  /// What `frames` look at, where they were stuffed.
  std::shared_ptr<const std::vector<std::vector<std::uint8_t>>> packets{};
  std::size_t stuffed_bytes = 0;       ///< of them, with their delimiters
  std::optional<std::size_t> id_at{};  ///< the identifier that tells the length

  std::size_t bytes() const;  ///< of the capture, in all frames
  bool has_one_length() const;
};

/// Where the byte behind a frame, as long as a field of it says, begins with the same sync again.
/// The guess that most bytes follow; with a checksum, before those without. Empty: none is
/// plausible.
std::optional<BinaryGuess> guess_lengths(wire::Bytes capture);

/// Where no field says the length but an identifier behind the sync tells it: messages of fixed
/// lengths in one stream. Empty: none is plausible.
std::optional<BinaryGuess> guess_ids(wire::Bytes capture);

/// Frames of one length, by the distance at which bytes repeat: the shortest with a checksum that
/// is right.
std::optional<BinaryGuess> guess_period(wire::Bytes capture);

/// Packets between delimiters, proved by a checksum or by DLE and ETX.
std::optional<BinaryGuess> guess_stuffed(wire::Bytes capture);

/// As a description: the messages that the frames are, and their fields; and how many of the
/// capture's bytes are in none.
std::string binary_text(const BinaryGuess& guess, std::size_t capture_bytes);

}  // namespace drydock::guess
