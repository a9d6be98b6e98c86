#include "drivers/guess/binary_guess.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "drivers/wire/described/plan.hpp"

/// A sync, a length and how much it leaves out belong together where the byte behind a frame so
/// measured begins with that sync again, time after time.
namespace drydock::guess {
namespace {

using wire::Bytes;

constexpr std::size_t fewest_frames = 4, shortest = 6, furthest_length = 10, most_plus = 64;
constexpr std::size_t longest = wire::described::longest_frame;
constexpr std::size_t most_tried = 128, neighbours = 3;

/// Every place at which these bytes stand.
struct Sync {
  std::array<std::uint8_t, 2> bytes{};
  std::size_t size = 2;
  std::vector<std::uint32_t> places;

  bool stands(Bytes capture, std::size_t at) const {
    return at + size <= capture.size() && capture[at] == bytes[0] &&
           (size == 1 || capture[at + 1] == bytes[1]);
  }
};

std::vector<Sync> syncs_of(Bytes capture) {
  std::vector<Sync> pairs(0x10000), singles(0x100);
  for (std::size_t i = 0; i + 1 < capture.size(); ++i) {
    const auto place = static_cast<std::uint32_t>(i);
    pairs[capture[i] << 8 | capture[i + 1]].places.push_back(place);
    singles[capture[i]].places.push_back(place);
  }
  std::vector<Sync> all;
  for (std::size_t i = 0; i < pairs.size() + singles.size(); ++i) {
    const bool pair = i < pairs.size();
    Sync& one = pair ? pairs[i] : singles[i - pairs.size()];
    if (one.places.size() < fewest_frames || one.places.size() * shortest > capture.size())
      continue;
    one.size = pair ? 2 : 1;
    one.bytes = pair ? std::array{static_cast<std::uint8_t>(i >> 8), static_cast<std::uint8_t>(i)}
                     : std::array{static_cast<std::uint8_t>(i - pairs.size()), std::uint8_t{0}};
    all.push_back(std::move(one));
  }
  return all;
}

std::size_t value_of(const LengthField& field, Bytes capture, std::size_t frame) {
  const std::size_t first = capture[frame + field.at];
  if (field.size == 1) return first;
  const std::size_t second = capture[frame + field.at + 1];
  return field.big_endian ? first << 8 | second : second << 8 | first;
}

struct Tried {
  const Sync* sync = nullptr;
  LengthField field;
  std::size_t bytes = 0;  ///< in frames behind which the next one begins
  bool varies = false;    ///< their lengths differ
};

/// For each number that the field may leave out: the bytes of frames that then reach the next sync.
Tried best_plus(const Sync& sync, LengthField field, Bytes capture) {
  struct Links {
    std::size_t count = 0, bytes = 0, first = 0;  ///< first: its length
    bool varies = false;
  };
  std::array<Links, most_plus + 1> all{};
  for (std::size_t i = 0; i + 1 < sync.places.size(); ++i) {
    const std::size_t frame = sync.places[i];
    if (frame + field.at + field.size > capture.size()) break;
    const std::size_t value = value_of(field, capture, frame);
    for (std::size_t j = i + 1; j < std::min(i + 1 + neighbours, sync.places.size()); ++j) {
      const std::size_t distance = sync.places[j] - frame;
      if (distance < value || distance - value > most_plus) continue;
      if (distance < std::max(shortest, field.at + field.size) || distance > longest) continue;
      Links& links = all[distance - value];
      if (links.count++ == 0) links.first = distance;
      links.bytes += distance;
      links.varies |= distance != links.first;
    }
  }
  const auto best = std::ranges::max_element(all, {}, &Links::bytes);
  field.plus = static_cast<std::size_t>(best - all.begin());
  return {&sync, field, best->count + 1 < fewest_frames ? 0 : best->bytes, best->varies};
}

std::vector<Tried> most_promising(const std::vector<Sync>& syncs, Bytes capture) {
  std::vector<Tried> all;
  for (const Sync& sync : syncs) {
    std::vector<Tried> of_sync;
    for (std::size_t at = 1; at <= furthest_length; ++at)
      for (const auto& [size, big] : {std::pair{2, false}, {2, true}, {1, false}}) {
        if (at < sync.size) continue;
        const LengthField field{at, static_cast<std::size_t>(size), big};
        const Tried one = best_plus(sync, field, capture);
        if (one.bytes > 0) of_sync.push_back(one);
      }
    // The wider field comes first: the upper half of a length may be always zero.
    std::ranges::stable_sort(of_sync, std::ranges::greater{}, &Tried::bytes);
    std::size_t varying = 0, constant = 0;
    for (const Tried& one : of_sync)
      if (one.varies ? varying++ < 3 : constant++ < 1) all.push_back(one);
  }
  std::ranges::stable_sort(all, std::ranges::greater{}, &Tried::bytes);
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

/// `sum`: the checksum, if it is known.
BinaryGuess guess_of(const Tried& tried, Bytes capture, std::optional<Sum> sum = {}) {
  BinaryGuess guess{tried.sync->size, tried.field, sum, {}};
  if (!guess.sum) guess.frames = linked_frames(tried, capture);
  if (!guess.sum && guess.frames.size() < fewest_frames) return {};
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
  // The upper half of a length is no part of a sync. What stands at the end of each frame stands
  // before the next one as well: the first frame tells which it is.
  const auto rank = [](const BinaryGuess& g) {
    return std::tuple(2 - (g.length ? g.length->size : 0), 2 - g.sync, g.sum ? g.sum->behind : 0,
                      g.frames.front().data());
  };
  return rank(a) < rank(b);
}

}  // namespace

std::optional<BinaryGuess> guess_lengths(Bytes capture) {
  constexpr std::size_t enough = 1u << 18;
  const Bytes head = capture.first(std::min(capture.size(), enough));
  std::optional<BinaryGuess> best;
  Tried found;
  const auto syncs = syncs_of(head);
  for (const Tried& tried : most_promising(syncs, head)) {
    BinaryGuess guess = guess_of(tried, head);
    if (!is_plausible(guess, head) || (best && !is_better(guess, *best))) continue;
    best = std::move(guess);
    found = tried;
  }
  if (best && head.size() < capture.size()) best = guess_of(found, capture, best->sum);
  return best;
}

}  // namespace drydock::guess
