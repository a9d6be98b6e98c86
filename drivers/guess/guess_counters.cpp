#include "drivers/guess/guess_counters.hpp"

#include <algorithm>
#include <optional>

namespace drydock::guess {
namespace {

constexpr std::size_t fewest_counted = 16;

std::uint64_t count_in(const NumberPlace& place, wire::Bytes frame) {
  return static_cast<std::uint64_t>(place.integer(frame)) & ~0ull >> (64 - 8 * place.size);
}

/// The byte of this significance, 0 the lowest.
std::uint8_t byte_of(const NumberPlace& place, wire::Bytes frame, std::size_t significance) {
  return static_cast<std::uint8_t>(count_in(place, frame) >> 8 * significance);
}

struct Steps {
  std::size_t all = 0, of_one = 0, backward = 0;
  std::size_t carries = 0;  ///< steps of one into the highest byte

  Steps(const Frames& frames, const NumberPlace& place) {
    const std::uint64_t most = ~0ull >> (64 - 8 * place.size), below_highest = most >> 8;
    for (std::size_t i = 1; i < frames.size(); ++i) {
      const std::uint64_t before = count_in(place, frames[i - 1]), now = count_in(place, frames[i]);
      const bool one = ((now - before) & most) == 1;
      ++all;
      of_one += one;
      backward += now < before;
      carries += one && (now & below_highest) == 0;
    }
  }
  bool count() const { return of_one * 10 >= all * 9; }
};

bool is_zero(const Frames& frames, const NumberPlace& place, std::size_t significance) {
  return std::ranges::all_of(
      frames, [&](wire::Bytes frame) { return byte_of(place, frame, significance) == 0; });
}

/// A count of four bytes is seldom so long that its third one changes: the upper ones are 0 then.
bool counts_frames(const Frames& frames, const NumberPlace& place) {
  const Steps steps(frames, place);
  if (!steps.count()) return false;
  if (place.size == 1 || steps.carries > 0) return true;
  if (place.size != 4) return false;
  const auto moves = [&](std::size_t significance) {
    return byte_of(place, frames.front(), significance) !=
           byte_of(place, frames.back(), significance);
  };
  const bool is_young = is_zero(frames, place, 3) && is_zero(frames, place, 2) &&
                        (moves(1) || is_zero(frames, place, 1));
  return steps.backward == 0 && (moves(2) || is_young);
}

Guessed counter_at(const Frames& frames, const NumberPlace& place) {
  const auto value = [&](wire::Bytes frame) { return count_in(place, frame); };
  const auto [low, high] = std::ranges::minmax(frames, {}, value);
  return {Guessed::Looks::counter,
          place.at,
          place.size,
          place.size == 4   ? "u32"
          : place.size == 2 ? "u16"
                            : "u8",
          place.big_endian && place.size > 1,
          static_cast<double>(value(low)),
          static_cast<double>(value(high))};
}

}  // namespace

std::vector<Guessed> guess_counters(const Frames& frames, std::size_t from, std::size_t end,
                                    const std::vector<std::size_t>& known) {
  std::vector<Guessed> all;
  if (frames.size() < fewest_counted) return all;
  const auto is_free = [&](const NumberPlace& place) {
    for (std::size_t at = place.at; at < place.at + place.size; ++at) {
      if (at >= end || std::ranges::find(known, at) != known.end()) return false;
      for (const Guessed& one : all)
        if (at >= one.at && at < one.at + one.size) return false;
    }
    return true;
  };
  for (const std::size_t size : {4, 2, 1})
    for (std::size_t at = from; at + size <= end; ++at)
      for (const bool big : {false, true}) {
        const NumberPlace place{at, size, false, big};
        if (is_free(place) && counts_frames(frames, place))
          all.push_back(counter_at(frames, place));
      }
  std::ranges::sort(all, {}, &Guessed::at);
  return all;
}

}  // namespace drydock::guess
