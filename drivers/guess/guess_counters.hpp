#pragma once

#include <vector>

#include "drivers/guess/guess_numbers.hpp"

namespace drydock::guess {

/// Integers of one, two or four bytes, from `from` up to `end`, that count the frames: by one from
/// each to the next, with a carry into each byte that they are said to have. Rising; they do not
/// overlap. Bytes that are `known` are left out.
std::vector<Guessed> guess_counters(const Frames& frames, std::size_t from, std::size_t end,
                                    const std::vector<std::size_t>& known);

}  // namespace drydock::guess
