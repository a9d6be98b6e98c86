#pragma once

#include <cstdint>
#include <vector>

#include "drivers/guess/binary_guess.hpp"

namespace drydock::guess {

/// Frames of one kind.
struct MessageGuess {
  std::vector<std::uint8_t> id;  ///< at the places of MessageGuesses
  Frames frames;
  std::size_t shortest = 0, longest = 0;  ///< bytes
};

struct MessageGuesses {
  std::vector<std::size_t> id_at;  ///< bytes behind the sync that tell kinds apart; rising
  std::vector<MessageGuess> all;   ///< the most frequent first
};

MessageGuesses guess_messages(const BinaryGuess& guess);

}  // namespace drydock::guess
