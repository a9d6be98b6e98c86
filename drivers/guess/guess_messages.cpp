#include "drivers/guess/guess_messages.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

/// Kinds of frames differ in length. The bytes that tell a frame's length best, for the number of
/// kinds that they make, are its identifier: the shortest description of all lengths (J. Rissanen,
/// Modeling by shortest data description, Automatica 14, 1978).
namespace drydock::guess {
namespace {

using wire::Bytes;
using Id = std::vector<std::uint8_t>;

constexpr std::size_t furthest_id = 8, most_id_bytes = 3;

Id id_of(Bytes frame, const std::vector<std::size_t>& places) {
  Id id;
  for (const std::size_t at : places) id.push_back(frame[at]);
  return id;
}

/// Bits that tell the kinds, and the length of each frame within its kind.
double cost_of(const Frames& frames, const std::vector<std::size_t>& places) {
  constexpr double bits_of_a_kind = 8, bits_of_a_length = 12;
  std::map<Id, std::map<std::size_t, std::size_t>> lengths;
  for (const Bytes frame : frames) ++lengths[id_of(frame, places)][frame.size()];
  double bits = 0;
  for (const auto& [id, counts] : lengths) {
    double all = 0;
    for (const auto& [length, count] : counts) all += static_cast<double>(count);
    bits += bits_of_a_kind + bits_of_a_length * static_cast<double>(counts.size());
    for (const auto& [length, count] : counts)
      bits -= static_cast<double>(count) * std::log2(static_cast<double>(count) / all);
  }
  return bits;
}

bool is_length(const BinaryGuess& guess, std::size_t at) {
  return guess.length && at >= guess.length->at && at < guess.length->at + guess.length->size;
}

/// The bits of all bytes, each by its column in the frames of its kind.
double bits_by_column(const Frames& frames) {
  constexpr std::size_t most_columns = 64, most_frames = 512;
  std::size_t end = most_columns;
  for (const Bytes frame : frames) end = std::min(end, frame.size());
  const Frames some(frames.begin(),
                    frames.begin() + std::ptrdiff_t(std::min(frames.size(), most_frames)));
  const std::vector<double> bits = ByteCosts(some, end).bits;
  return std::accumulate(bits.begin(), bits.end(), 0.0);
}

/// True if each value of the byte has always the same one behind it: messages in turn. A counter
/// begins at 0.
bool goes_round(const Frames& frames, std::size_t at) {
  std::map<std::uint8_t, std::map<std::uint8_t, std::size_t>> next;
  for (std::size_t i = 1; i < frames.size(); ++i) ++next[frames[i - 1][at]][frames[i][at]];
  std::size_t usual = 0;
  for (const auto& [value, behind] : next)
    usual +=
        std::ranges::max_element(behind, {}, [](const auto& one) { return one.second; })->second;
  return next.begin()->first != 0 && usual * 20 >= (frames.size() - 1) * 19;
}

/// Kinds of one length: a byte behind the sync with few values is an identifier if they come in
/// turn, or if the frames with each value take much fewer bits than all together.
std::vector<std::size_t> id_of_one_length(const BinaryGuess& guess, std::size_t end) {
  constexpr std::size_t most_kinds = 16, fewest_of_a_kind = 4, furthest = 2;
  for (std::size_t at = guess.sync; at < std::min(end, guess.sync + furthest); ++at) {
    std::map<std::uint8_t, Frames> kinds;
    for (const Bytes frame : guess.frames) kinds[frame[at]].push_back(frame);
    if (is_length(guess, at) || kinds.size() < 2 || kinds.size() > most_kinds) continue;
    double bits = 0;
    for (const auto& [value, frames] : kinds) bits += bits_by_column(frames);
    const bool often = std::ranges::all_of(
        kinds, [](const auto& kind) { return kind.second.size() >= fewest_of_a_kind; });
    if (!often) continue;
    if (goes_round(guess.frames, at) || bits < 0.9 * bits_by_column(guess.frames)) return {at};
  }
  return {};
}

std::vector<std::size_t> id_places(const BinaryGuess& guess) {
  if (guess.id_at) return {*guess.id_at};
  std::size_t end = furthest_id;
  for (const Bytes frame : guess.frames) end = std::min(end, frame.size());
  std::vector<std::size_t> places;
  double cost = cost_of(guess.frames, places);
  while (places.size() < most_id_bytes) {
    std::vector<std::size_t> best;
    for (std::size_t at = guess.sync; at < end; ++at) {
      if (is_length(guess, at) || std::ranges::find(places, at) != places.end()) continue;
      auto tried = places;
      tried.push_back(at);
      const double bits = cost_of(guess.frames, tried);
      if (bits >= cost) continue;
      cost = bits;
      best = std::move(tried);
    }
    if (best.empty()) break;
    places = std::move(best);
  }
  if (places.empty()) return id_of_one_length(guess, end);
  // A class before the identifier is part of it.
  const std::size_t last = std::ranges::max(places);
  std::vector<std::size_t> all;
  for (std::size_t at = guess.sync; at <= last; ++at)
    if (!is_length(guess, at)) all.push_back(at);
  return all.size() <= most_id_bytes ? all : (std::ranges::sort(places), places);
}

}  // namespace

MessageGuesses guess_messages(const BinaryGuess& guess) {
  MessageGuesses found{id_places(guess), {}};
  std::map<Id, MessageGuess> kinds;
  for (const Bytes frame : guess.frames) {
    MessageGuess& one = kinds[id_of(frame, found.id_at)];
    one.shortest = one.frames.empty() ? frame.size() : std::min(one.shortest, frame.size());
    one.longest = std::max(one.longest, frame.size());
    one.frames.push_back(frame);
  }
  for (auto& [id, one] : kinds) {
    one.id = id;
    found.all.push_back(std::move(one));
  }
  std::ranges::stable_sort(found.all, std::ranges::greater{},
                           [](const MessageGuess& m) { return m.frames.size(); });
  return found;
}

}  // namespace drydock::guess
