#include <algorithm>

#include "drivers/survey/binary_guess.hpp"

namespace drydock::survey {
namespace {

using wire::Bytes;

constexpr std::size_t longest_period = 512, fewest_periods = 4;

/// The distance at which bytes are most often equal: the length of frames, or a multiple of it.
std::size_t period_of(Bytes capture) {
  std::size_t best = 0, most = 0;
  const std::size_t limit = std::min(longest_period, capture.size() / fewest_periods);
  for (std::size_t lag = 4; lag <= limit; ++lag) {
    std::size_t equal = 0;
    for (std::size_t i = 0; i + lag < capture.size(); ++i) equal += capture[i] == capture[i + lag];
    if (equal > most + most / 50) {  // a multiple of a period is no better
      best = lag;
      most = equal;
    }
  }
  return most * 8 > capture.size() ? best : 0;
}

/// Cuts at those places that share the two bytes of the first cut.
Frames cut(Bytes capture, std::size_t phase, std::size_t length) {
  Frames frames;
  for (std::size_t at = phase; at + length <= capture.size();) {
    const bool synced = capture[at] == capture[phase] && capture[at + 1] == capture[phase + 1];
    if (synced) frames.push_back(capture.subspan(at, length));
    at += synced ? length : 1;
  }
  return frames;
}

}  // namespace

std::optional<BinaryGuess> guess_period(Bytes capture) {
  constexpr std::size_t enough = 1u << 18;
  capture = capture.first(std::min(capture.size(), enough));
  const std::size_t length = period_of(capture);
  if (length == 0) return {};
  std::optional<BinaryGuess> best;
  for (std::size_t phase = 0; phase < length && phase + length < capture.size(); ++phase) {
    BinaryGuess guess;
    guess.frames = cut(capture, phase, length);
    if (guess.frames.size() < fewest_periods || !is_constant(guess.frames, 0)) continue;
    guess.sum = guess_checksum(guess.frames);
    if (guess.sum) return guess;
    if (!best || guess.frames.size() > best->frames.size()) best = std::move(guess);
  }
  return best;
}

}  // namespace drydock::survey
