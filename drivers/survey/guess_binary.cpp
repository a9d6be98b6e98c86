#include <algorithm>

#include "drivers/survey/binary_guess.hpp"
#include "drivers/survey/guess.hpp"

namespace drydock::survey {

std::size_t BinaryGuess::bytes() const {
  std::size_t all = 0;
  for (const wire::Bytes frame : frames) all += frame.size();
  return all;
}

bool BinaryGuess::has_one_length() const {
  return std::ranges::all_of(
      frames, [&](wire::Bytes frame) { return frame.size() == frames.front().size(); });
}

namespace {

/// A length that changes and a checksum prove each other. Without a checksum the guess counts that
/// explains more of the capture.
std::optional<BinaryGuess> best_guess(wire::Bytes capture) {
  auto by_length = guess_lengths(capture);
  if (by_length && by_length->sum && by_length->length) return by_length;
  auto by_period = guess_period(capture);
  if (!by_length || !by_period) return by_length ? by_length : by_period;
  const auto rank = [](const BinaryGuess& g) { return std::pair(g.sum.has_value(), g.bytes()); };
  return rank(*by_length) > rank(*by_period) ? by_length : by_period;
}

}  // namespace

std::string guess_binary(wire::Bytes capture) {
  const auto guess = best_guess(capture);
  return guess ? binary_text(*guess) : std::string();
}

}  // namespace drydock::survey
