#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "drivers/wire/codec.hpp"

/// What it takes to write bytes of frames as values of a type, each after the one before it.
namespace drydock::guess {

using Frames = std::vector<wire::Bytes>;

/// Bytes of each frame that may be one number.
struct NumberPlace {
  std::size_t at = 0, size = 1;
  bool is_real = false, big_endian = false;

  std::size_t most_significant() const { return big_endian ? at : at + size - 1; }
  std::size_t least_significant() const { return big_endian ? at + size - 1 : at; }
  std::int64_t integer(wire::Bytes frame) const;  ///< with its sign
  double real(wire::Bytes frame) const;
};

/// The bits that each byte alone takes, and bytes that never change.
struct ByteCosts {
  std::vector<double> bits;
  std::vector<bool> is_fixed;
  double frames = 0;

  ByteCosts(const Frames& frames, std::size_t end);
  /// True if nothing foretells the byte: what is below the noise of a number.
  bool is_white(std::size_t at) const { return bits[at] >= 7.5 * frames; }
};

/// The bits of a number at this place, and those that tell its type. `is_usual`: most numbers of
/// the frame are such. Empty: it is none.
std::optional<double> number_cost(const Frames& frames, const NumberPlace& place,
                                  const ByteCosts& bytes, bool is_usual);

/// A clock of four or eight bytes advances by nearly the same from frame to frame.
bool is_clock(const Frames& frames, const NumberPlace& place);

}  // namespace drydock::guess
