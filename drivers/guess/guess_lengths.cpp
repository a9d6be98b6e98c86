#include "drivers/guess/binary_guess.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <tuple>

#include "drivers/guess/syncs.hpp"
#include "drivers/wire/described/plan.hpp"

/// A sync, a length and how much it leaves out belong together where the byte behind a frame so
/// measured begins with that sync again, time after time.
namespace drydock::guess {
namespace {

using wire::Bytes;

constexpr std::size_t fewest_frames = 4, furthest_length = 10, most_plus = 64;
constexpr std::size_t shortest = shortest_synced_frame;
constexpr std::size_t longest = wire::described::longest_frame;
constexpr std::size_t most_tried = 128, neighbours = 3;

std::size_t value_of(const LengthField& field, Bytes capture, std::size_t frame) {
  const std::size_t first = capture[frame + field.at];
  if (field.size == 1) return first;
  const std::size_t second = capture[frame + field.at + 1];
  return field.big_endian ? first << 8 | second : second << 8 | first;
}

struct Tried {
  const Sync* sync = nullptr;
  LengthField field;
  std::size_t bytes = 0;   ///< in frames behind which the next one begins
  std::size_t frames = 0;  ///< such
  bool varies = false;     ///< their lengths differ
};

/// Of two that explain as many bytes the one with shorter frames: a chain of frames that come in
/// turn has the sync behind it too.
bool promises_more(const Tried& a, const Tried& b) {
  return std::tie(a.bytes, a.frames) > std::tie(b.bytes, b.frames);
}

constexpr std::size_t pluses = 3;

/// The numbers that the field may leave out, those that most bytes follow first. A sync among the
/// values stands between two frames, so that a frame may end at a later one: the bytes up to the
/// second sync count half, as frames that begin at each sync in turn overlap.
std::array<std::size_t, pluses> likely_pluses(const Sync& sync, const LengthField& field,
                                              Bytes capture) {
  std::array<std::size_t, most_plus + 1> bytes{};
  for (std::size_t i = 0; i + 1 < sync.places.size(); ++i) {
    const std::size_t frame = sync.places[i];
    if (frame + field.at + field.size > capture.size()) break;
    const std::size_t value = value_of(field, capture, frame);
    for (std::size_t j = i + 1; j < std::min(i + 1 + neighbours, sync.places.size()); ++j) {
      const std::size_t distance = sync.places[j] - frame;
      if (distance < value || distance - value > most_plus) continue;
      if (distance < std::max(shortest, field.at + field.size) || distance > longest) continue;
      bytes[distance - value] += distance / (j - i);
    }
  }
  std::array<std::size_t, most_plus + 1> all{};
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::array<std::size_t, pluses> best{};
  std::ranges::partial_sort_copy(
      all, best, std::ranges::greater{}, [&](auto p) { return bytes[p]; },
      [&](auto p) { return bytes[p]; });
  return best;
}

/// Frames that do not overlap, with the sync behind each.
Tried chained(const Sync& sync, const LengthField& field, Bytes capture) {
  Tried tried{&sync, field};
  std::size_t next = 0, first = 0;
  for (const std::size_t frame : sync.places) {
    if (frame < next || frame + field.at + field.size > capture.size()) continue;
    const std::size_t size = value_of(field, capture, frame) + field.plus;
    if (size < std::max(shortest, field.at + field.size) || size > longest) continue;
    if (!sync.stands(capture, frame + size)) continue;
    if (tried.frames++ == 0) first = size;
    tried.varies |= size != first;
    tried.bytes += size;
    next = frame + size;
  }
  return tried;
}

std::vector<Tried> most_promising(const std::vector<Sync>& syncs, Bytes capture) {
  std::vector<Tried> all;
  for (const Sync& sync : syncs) {
    std::vector<Tried> of_sync;
    for (std::size_t at = sync.size; at <= furthest_length; ++at)
      for (const auto& [size, big] : {std::pair{2, false}, {2, true}, {1, false}}) {
        LengthField field{at, static_cast<std::size_t>(size), big};
        for (const std::size_t plus : likely_pluses(sync, field, capture)) {
          field.plus = plus;
          const Tried one = chained(sync, field, capture);
          if (one.frames + 1 >= fewest_frames) of_sync.push_back(one);
        }
      }
    // The wider field comes first: the upper half of a length may be always zero.
    std::ranges::stable_sort(of_sync, promises_more);
    std::size_t varying = 0, constant = 0;
    for (const Tried& one : of_sync)
      if (one.varies ? varying++ < pluses : constant++ < 1) all.push_back(one);
  }
  std::ranges::stable_sort(all, promises_more);
  all.resize(std::min(all.size(), most_tried));
  return all;
}

/// Length of the frame at this place; 0: none begins there.
std::size_t length_at(const Tried& tried, Bytes capture, std::size_t at) {
  const LengthField& field = tried.field;
  if (!tried.sync->stands(capture, at) || at + field.at + field.size > capture.size()) return 0;
  const std::size_t size = value_of(field, capture, at) + field.plus;
  const bool possible = size >= std::max(shortest, field.at + field.size) && size <= longest;
  return possible && at + size <= capture.size() ? size : 0;
}

/// Frames behind which the next one, or the end, comes.
Frames linked_frames(const Tried& tried, Bytes capture) {
  Frames frames;
  for (std::size_t at = 0; at < capture.size();) {
    const std::size_t size = length_at(tried, capture, at);
    const bool linked =
        size > 0 && (at + size == capture.size() || tried.sync->stands(capture, at + size));
    if (linked) frames.push_back(capture.subspan(at, size));
    at += linked ? size : 1;
  }
  return frames;
}

Frames checked_frames(const Tried& tried, const Sum& sum, Bytes capture) {
  Frames frames;
  for (std::size_t at = 0; at < capture.size();) {
    const std::size_t size = length_at(tried, capture, at);
    const bool right = size > 0 && sum.is_right(capture.subspan(at, size));
    if (right) frames.push_back(capture.subspan(at, size));
    at += right ? size : 1;
  }
  return frames;
}

/// `linked`: its frames; `sum`: the checksum, if it is known.
BinaryGuess guess_of(const Tried& tried, Bytes capture, Frames linked,
                     std::optional<Sum> sum = {}) {
  BinaryGuess guess{tried.sync->size, tried.field, sum, std::move(linked)};
  if (!guess.sum) guess.sum = guess_checksum(guess.frames);
  if (guess.sum) guess.frames = checked_frames(tried, *guess.sum, capture);
  const bool alike = std::ranges::all_of(
      guess.frames, [&](Bytes frame) { return frame[1] == guess.frames[0][1]; });
  if (alike && tried.field.at > 1) guess.sync = 2;
  // A field that never changes proves nothing.
  if (!guess.frames.empty() && guess.has_one_length()) guess.length.reset();
  return guess;
}

/// A checksum proves a frame. Without one, all of the capture must be frames.
bool is_plausible(const BinaryGuess& guess, Bytes capture) {
  if (guess.frames.size() < fewest_frames) return false;
  return guess.sum ? guess.bytes() * 4 > capture.size() : guess.bytes() * 10 > capture.size() * 9;
}

bool is_better(const BinaryGuess& a, const BinaryGuess& b) {
  if (a.sum.has_value() != b.sum.has_value()) return a.sum.has_value();
  if (a.bytes() != b.bytes()) return a.bytes() > b.bytes();
  if (a.frames.size() != b.frames.size()) return a.frames.size() > b.frames.size();
  // The upper half of a length is no part of a sync. What stands at the end of each frame stands
  // before the next one as well: the first frame tells which it is.
  const auto rank = [](const BinaryGuess& g) {
    return std::tuple(2 - (g.length ? g.length->size : 0), 2 - g.sync, g.sum ? g.sum->behind : 0,
                      g.frames.front().data());
  };
  return rank(a) < rank(b);
}

/// Nearly all bytes have a checksum that is right. Frames that explain as many follow each other
/// nearly all, so that far fewer that do are not worth a look at a hundred checksums.
bool is_hopeless(const Frames& linked, const BinaryGuess& best, Bytes capture) {
  if (!best.sum || best.bytes() * 10 < capture.size() * 9) return false;
  const auto bytes = std::transform_reduce(linked.begin(), linked.end(), std::size_t{0},
                                           std::plus{}, [](Bytes frame) { return frame.size(); });
  return bytes * 2 < best.bytes();
}

}  // namespace

std::optional<BinaryGuess> guess_lengths(Bytes capture) {
  constexpr std::size_t enough = 1u << 18;
  const Bytes head = capture.first(std::min(capture.size(), enough));
  std::optional<BinaryGuess> best;
  Tried found;
  const auto syncs = syncs_of(head);
  for (const Tried& tried : most_promising(syncs, head)) {
    Frames linked = linked_frames(tried, head);
    if (linked.size() < fewest_frames || (best && is_hopeless(linked, *best, head))) continue;
    BinaryGuess guess = guess_of(tried, head, std::move(linked));
    if (!is_plausible(guess, head) || (best && !is_better(guess, *best))) continue;
    best = std::move(guess);
    found = tried;
  }
  if (best && head.size() < capture.size()) best = guess_of(found, capture, {}, best->sum);
  return best;
}

}  // namespace drydock::guess
