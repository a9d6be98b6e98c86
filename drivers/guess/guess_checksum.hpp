#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "drivers/guess/guess_numbers.hpp"
#include "drivers/wire/described/checksums.hpp"

namespace drydock::guess {

/// A checksum of a description, and where it stands.
struct Sum {
  wire::described::Checksum checksum;
  bool big_endian = false;
  std::size_t from = 0;    ///< the first byte that it covers
  std::size_t behind = 0;  ///< bytes of the frame behind it
  /// Its first byte, where it stands in front of what it covers.
  std::optional<std::size_t> at{};

  /// Bytes of the frame behind its fields.
  std::size_t tail() const { return (at ? 0 : checksum.size()) + behind; }

  /// The bytes of a frame that it covers; empty: the frame is too short.
  wire::Bytes covered(wire::Bytes frame) const;
  /// What a frame that is not too short says of it.
  std::uint32_t stored(wire::Bytes frame) const;
  /// The checksum of a frame where it is right.
  std::optional<std::uint32_t> right_in(wire::Bytes frame) const;
  bool is_right(wire::Bytes frame) const { return right_in(frame).has_value(); }
};

/// The checksum that is right in nine of ten frames: one behind what it covers, else a plain sum of
/// the payload that stands in the header. Empty: none of the catalogue is.
std::optional<Sum> guess_checksum(const Frames& frames);

/// The bytes that end all frames behind a checksum, as a description writes them: "0D 0A".
std::string hex_of(wire::Bytes bytes);

}  // namespace drydock::guess
