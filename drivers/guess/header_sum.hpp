#pragma once

#include <optional>
#include <string>

#include "drivers/guess/binary_guess.hpp"

namespace drydock::guess {

/// A checksum of the bytes of a frame from `from` to before `to`, which stands behind them.
struct HeaderSum {
  wire::described::Checksum checksum;
  bool big_endian = false;
  std::size_t at = 0, from = 0, to = 0;

  bool is_right(wire::Bytes frame) const;
  std::string text() const;  ///< the line of a description
};

/// One that is right in all frames, of bytes that change, and that is no copy of one of them.
std::optional<HeaderSum> guess_header_sum(const BinaryGuess& guess);

}  // namespace drydock::guess
