#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "drivers/guess/guess_checksum.hpp"

namespace drydock::guess {

/// Pairs of frames of one length. A CRC is linear: in the XOR of two frames its start value and its
/// last XOR fall out. So what a pair says serves all CRCs of one polynomial, and all that begin
/// before the first byte in which the two differ.
class CrcPairs {
 public:
  explicit CrcPairs(const Frames& frames);

  /// Whether `sum`, a CRC that stands behind what it covers, can be right in both frames of a pair,
  /// with either byte order. True if there are too few pairs to say no.
  bool allow(const Sum& sum);

 private:
  static constexpr std::size_t at_once = 3, rounds = 2;  ///< Checksum::of_three; some are damaged

  /// Three pairs: the XOR of each, and the first byte that is not 0 in all of them.
  struct Three {
    std::array<std::vector<std::uint8_t>, at_once> differences;
    std::size_t first = 0;
    std::map<std::array<std::uint64_t, 3>, std::array<std::uint32_t, at_once>> sums{};
  };

  static bool allows(Three& three, const Sum& sum);

  std::vector<Three> threes_;
};

}  // namespace drydock::guess
