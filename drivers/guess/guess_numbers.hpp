#pragma once

#include <string_view>
#include <vector>

#include "drivers/guess/number_cost.hpp"

/// What the bytes of frames look like: constants, counters, numbers.
namespace drydock::guess {

/// Bytes of each frame that are read together.
struct Guessed {
  enum class Looks : std::uint8_t { constant, counter, number, byte };
  Looks looks = Looks::byte;
  std::size_t at = 0, size = 1;
  std::string_view type = "u8";  ///< as a description calls it
  bool big_endian = false;
  double low = 0, high = 0;  ///< of its values
};

/// True if nine of ten frames have the first one's byte there.
bool is_constant(const Frames& frames, std::size_t at);

/// The bytes from `from` up to `end`, which all frames have, in order: of all ways to cut them into
/// numbers of one byte order the one that takes fewest bits. Bytes that are `known` are left out;
/// no number reaches over one.
std::vector<Guessed> guess_numbers(const Frames& frames, std::size_t from, std::size_t end,
                                   const std::vector<std::size_t>& known = {});

}  // namespace drydock::guess
