#include "drivers/guess/doubts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace drydock::guess {

std::optional<std::size_t> wider_counter_at(const Guessed& one, const std::vector<Guessed>& all) {
  if (one.size != 2 || one.high >= 0xFFFF || (one.big_endian && one.at < 2)) return std::nullopt;
  const std::size_t above = one.big_endian ? one.at - 2 : one.at + 2;
  const auto never_changes = [&](std::size_t at) {
    return std::ranges::any_of(all, [&](const Guessed& other) {
      return other.looks == Guessed::Looks::constant && other.at == at && other.low == other.high;
    });
  };
  if (!never_changes(above) || !never_changes(above + 1)) return std::nullopt;
  return std::min(above, one.at);
}

std::string doubt_text(const BinaryGuess& guess, const MessageGuesses& kinds) {
  if (guess.sum || guess.length || guess.packets || kinds.all.size() > 1) return {};
  const Frames& frames = guess.frames;
  const std::uint8_t first = frames[0][0];
  std::vector<std::size_t> places;
  for (std::size_t at = 1; at < frames[0].size(); ++at)
    if (std::ranges::all_of(frames, [&](wire::Bytes frame) { return frame[at] == first; }))
      places.push_back(at);
  constexpr std::size_t most_messages = 16;
  const bool says_nothing = first == 0 || first == 0xFF;  // as upper bytes of numbers
  if (places.empty() || places.size() >= most_messages || says_nothing) return {};
  return fmt::format(
      "# Doubtful: byte {:02X} of the beginning stands at {} too, always: these may be several "
      "messages in turn.\n",
      first, fmt::join(places, " and "));
}

}  // namespace drydock::guess
