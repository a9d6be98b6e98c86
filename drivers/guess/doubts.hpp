#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "drivers/guess/binary_guess.hpp"
#include "drivers/guess/guess_messages.hpp"

/// What a capture leaves open although the guess explains all of it.
namespace drydock::guess {

/// Where a counter of two bytes begins if it has four, of which the upper two never changed. Empty
/// if those change, or if it turned without them.
std::optional<std::size_t> wider_counter_at(const Guessed& one, const std::vector<Guessed>& all);

/// Messages that come strictly in turn repeat as one long frame does. Where neither a checksum nor
/// a second byte of sync tells which they are, the beginning of each is one byte that stands at
/// several places.
std::string doubt_text(const BinaryGuess& guess, const MessageGuesses& kinds);

}  // namespace drydock::guess
