#include <algorithm>

#include "drivers/guess/binary_guess.hpp"
#include "drivers/guess/guess.hpp"

namespace drydock::guess {

std::size_t BinaryGuess::bytes() const {
  if (packets) return stuffed_bytes;
  std::size_t all = 0;
  for (const wire::Bytes frame : frames) all += frame.size();
  return all;
}

bool BinaryGuess::has_one_length() const {
  return std::ranges::all_of(
      frames, [&](wire::Bytes frame) { return frame.size() == frames.front().size(); });
}

namespace {

/// Frames whose sum is zero make longer ones whose sum is zero too.
bool cuts_shorter(const std::optional<BinaryGuess>& a, const std::optional<BinaryGuess>& b) {
  return a && b && a->sum.has_value() == b->sum.has_value() &&
         a->frames.size() > b->frames.size() && a->bytes() * 50 > b->bytes() * 49;
}

/// With a checksum, or as much as the other has and many more bytes.
bool tells_more(const std::optional<BinaryGuess>& a, const std::optional<BinaryGuess>& b) {
  if (!a || !b) return a.has_value();
  if (a->sum.has_value() != b->sum.has_value()) return a->sum.has_value();
  return a->bytes() * 49 > b->bytes() * 50;
}

/// A length that changes and a checksum prove each other. Without one the guess counts that
/// explains more of the capture, and of two that explain as much the one with shorter frames.
std::optional<BinaryGuess> plain_guess(wire::Bytes capture) {
  auto by_length = guess_lengths(capture), by_id = guess_ids(capture);
  const bool by_field = by_length && by_length->length && !tells_more(by_id, by_length) &&
                        !cuts_shorter(by_id, by_length);
  if (by_field && by_length->sum) return by_length;
  auto by_period = guess_period(capture);
  const bool others = tells_more(by_period, by_id) || tells_more(by_length, by_id);
  if (by_id && !by_field && !others) return by_id;
  if (!by_length || !by_period) return by_length ? by_length : by_period;
  if (by_length->sum.has_value() != by_period->sum.has_value())
    return by_length->sum ? by_length : by_period;
  const std::size_t length = by_length->bytes(), period = by_period->bytes();
  if (std::max(length, period) * 49 < std::min(length, period) * 50)
    return by_length->frames.size() > by_period->frames.size() ? by_length : by_period;
  return length > period ? by_length : by_period;
}

/// Frames that are not stuffed count only if they explain more.
std::optional<BinaryGuess> best_guess(wire::Bytes capture) {
  auto stuffed = guess_stuffed(capture), plain = plain_guess(capture);
  if (!stuffed || !plain) return stuffed ? stuffed : plain;
  if (plain->sum && (!stuffed->sum || plain->bytes() * 49 > stuffed->bytes() * 50)) return plain;
  return stuffed;
}

}  // namespace

std::string guess_binary(wire::Bytes capture) {
  const auto guess = best_guess(capture);
  return guess ? binary_text(*guess, capture.size()) : std::string();
}

}  // namespace drydock::guess
