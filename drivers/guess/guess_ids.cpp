#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>

#include "drivers/guess/binary_guess.hpp"
#include "drivers/guess/syncs.hpp"
#include "drivers/wire/described/plan.hpp"

/// Messages of fixed lengths that an identifier behind the sync tells apart. No byte says the
/// length: it is the distance at which, behind this identifier, the sync stands again.
namespace drydock::guess {
namespace {

using wire::Bytes;

constexpr std::size_t furthest_id_byte = 3, fewest_id_frames = 16, fewest_of_an_id = 4;
constexpr std::size_t most_id_kinds = wire::described::most_messages, most_ids_tried = 16;
constexpr std::size_t enough_for_ids = 1u << 16;

/// Bytes of the frames with each identifier; 0: there is none.
using Lengths = std::array<std::size_t, 256>;

struct TriedId {
  const Sync* sync = nullptr;
  std::size_t id_at = 0;
  Lengths lengths{};
  std::size_t bytes = 0, frames = 0;
  bool in_turn = true;  ///< behind each identifier always comes the same one
};

/// A sync of one byte stands in the values too: of these places few have an identifier behind them,
/// and many lie between two frames.
std::size_t neighbours_of(const Sync& sync) { return sync.size == 1 ? 16 : 4; }

/// True if few values stand there often, and seldom others.
bool may_be_id(const Sync& sync, std::size_t at, Bytes capture) {
  std::array<std::size_t, 256> times{};
  for (const std::size_t place : sync.places)
    if (place + at < capture.size()) ++times[capture[place + at]];
  const std::size_t by_chance = sync.size == 1 ? sync.places.size() / times.size() : 0;
  const std::size_t often = std::max(fewest_of_an_id, 4 * by_chance);
  std::size_t kinds = 0, covered = 0;
  for (const std::size_t one : times) {
    kinds += one >= often;
    covered += one >= often ? one : 0;
  }
  const std::size_t quarters = sync.size == 1 ? 1 : 3;
  return kinds >= 2 && kinds <= most_id_kinds && covered * 4 >= sync.places.size() * quarters;
}

/// The shortest of the distances that come nearly as often as any: behind a frame stand more.
std::size_t usual_distance(const std::map<std::size_t, std::size_t>& times) {
  std::size_t most = 0;
  for (const auto& [distance, count] : times) most = std::max(most, count);
  const auto usual =
      std::ranges::find_if(times, [&](const auto& one) { return one.second * 10 >= most * 9; });
  return usual == times.end() || usual->second < fewest_of_an_id ? 0 : usual->first;
}

Lengths lengths_of(const Sync& sync, std::size_t id_at, Bytes capture) {
  std::array<std::map<std::size_t, std::size_t>, 256> distances;
  std::array<std::size_t, 256> times{};
  for (std::size_t i = 0; i + 1 < sync.places.size(); ++i) {
    const std::size_t frame = sync.places[i];
    if (frame + id_at >= capture.size()) break;
    const std::uint8_t id = capture[frame + id_at];
    ++times[id];
    for (std::size_t j = i + 1; j < std::min(i + 1 + neighbours_of(sync), sync.places.size());
         ++j) {
      const std::size_t distance = sync.places[j] - frame;
      if (distance > id_at && distance >= shortest_synced_frame - 1 &&
          distance <= wire::described::longest_frame)
        ++distances[id][distance];
    }
  }
  Lengths lengths{};
  for (std::size_t id = 0; id < lengths.size(); ++id) {
    const std::size_t length = usual_distance(distances[id]);
    if (length > 0 && distances[id][length] * 4 >= times[id] * 3) lengths[id] = length;
  }
  return lengths;
}

std::size_t length_by_id(const TriedId& tried, Bytes capture, std::size_t at) {
  if (!tried.sync->stands(capture, at) || at + tried.id_at >= capture.size()) return 0;
  const std::size_t length = tried.lengths[capture[at + tried.id_at]];
  return at + length <= capture.size() ? length : 0;
}

/// Frames behind which the next one, or the end, comes; with a checksum those where it is right.
Frames frames_by_id(const TriedId& tried, Bytes capture, const std::optional<Sum>& sum) {
  Frames frames;
  for (std::size_t at = 0; at < capture.size();) {
    const std::size_t size = length_by_id(tried, capture, at);
    const std::size_t end = at + size;
    bool good = size > 0;
    if (good)
      good = sum ? sum->is_right(capture.subspan(at, size))
                 : end == capture.size() || tried.sync->stands(capture, end);
    if (good) frames.push_back(capture.subspan(at, size));
    at += good ? size : 1;
  }
  return frames;
}

/// Keeps the kinds that come often; empty: they are not several, or all of one length.
std::optional<TriedId> id_tried_with(const Sync& sync, std::size_t id_at, Bytes capture) {
  if (!may_be_id(sync, id_at, capture)) return {};
  TriedId tried{&sync, id_at, lengths_of(sync, id_at, capture)};
  std::map<std::uint8_t, std::size_t> times;
  for (const Bytes frame : frames_by_id(tried, capture, {})) ++times[frame[id_at]];
  std::set<std::size_t> lengths;
  for (std::size_t id = 0; id < tried.lengths.size(); ++id) {
    const auto found = times.find(static_cast<std::uint8_t>(id));
    if (found == times.end() || found->second < fewest_of_an_id) tried.lengths[id] = 0;
    if (tried.lengths[id] > 0) lengths.insert(tried.lengths[id]);
  }
  if (lengths.size() < 2) return {};
  std::map<std::uint8_t, std::set<std::uint8_t>> behind;
  const Frames frames = frames_by_id(tried, capture, {});
  for (std::size_t i = 0; i < frames.size(); ++i) {
    tried.bytes += frames[i].size();
    if (i > 0) behind[frames[i - 1][id_at]].insert(frames[i][id_at]);
  }
  tried.frames = frames.size();
  tried.in_turn =
      std::ranges::all_of(behind, [](const auto& one) { return one.second.size() == 1; });
  return tried.frames >= fewest_id_frames ? std::optional(tried) : std::nullopt;
}

BinaryGuess guess_of_id(const TriedId& tried, Bytes capture) {
  BinaryGuess guess{tried.sync->size, {}, {}, {}};
  guess.id_at = tried.id_at;
  guess.sum = guess_checksum(frames_by_id(tried, capture, {}));
  guess.frames = frames_by_id(tried, capture, guess.sum);
  return guess;
}

/// Messages that come in turn are one long frame too. Where no checksum tells that they are
/// several, the sync must be an unlikely one, and the first of the capture.
bool is_sure_sync(const Sync& sync, Bytes capture) {
  return sync.size == 2 && sync.bytes[0] != 0 && sync.bytes[1] != 0 &&
         sync.bytes[0] != sync.bytes[1] && sync.stands(capture, 0);
}

/// Without a checksum all must be frames.
bool is_plausible_id(const TriedId& tried, const BinaryGuess& guess, Bytes capture) {
  if (guess.frames.size() < fewest_id_frames) return false;
  if (guess.sum) return guess.bytes() * 2 > capture.size();
  return guess.bytes() * 10 > capture.size() * 9 &&
         (!tried.in_turn || is_sure_sync(*tried.sync, capture));
}

bool ends_many(std::uint8_t byte) { return byte == '\r' || byte == '\n' || byte == 0x03; }

/// Frames cut at another constant byte explain nearly as much: at both ends of a capture one may be
/// cut.
bool is_better_id(const BinaryGuess& a, const BinaryGuess& b) {
  if (a.sum.has_value() != b.sum.has_value()) return a.sum.has_value();
  const std::size_t more = std::max(a.bytes(), b.bytes()), less = std::min(a.bytes(), b.bytes());
  if (less * 50 < more * 49) return a.bytes() == more;
  const auto rank = [](const BinaryGuess& g) {
    return std::tuple(ends_many(g.frames[0][0]), 2 - g.sync, g.sum ? g.sum->behind : 0,
                      g.sum ? g.sum->from : 0, ~g.bytes(), *g.id_at, g.frames[0].data());
  };
  return rank(a) < rank(b);
}

}  // namespace

std::optional<BinaryGuess> guess_ids(Bytes capture) {
  const Bytes head = capture.first(std::min(capture.size(), enough_for_ids));
  const auto syncs = syncs_of(head);
  std::vector<TriedId> all;
  for (const Sync& sync : syncs)
    for (std::size_t at = sync.size; at <= sync.size + furthest_id_byte; ++at)
      if (auto tried = id_tried_with(sync, at, head)) all.push_back(*tried);
  std::ranges::stable_sort(all, [](const TriedId& a, const TriedId& b) {
    return std::tie(a.bytes, a.frames) > std::tie(b.bytes, b.frames);
  });
  all.resize(std::min(all.size(), most_ids_tried));
  std::optional<BinaryGuess> best;
  TriedId found;
  for (const TriedId& tried : all) {
    BinaryGuess guess = guess_of_id(tried, head);
    if (!is_plausible_id(tried, guess, head) || (best && !is_better_id(guess, *best))) continue;
    best = std::move(guess);
    found = tried;
  }
  if (best && head.size() < capture.size()) best->frames = frames_by_id(found, capture, best->sum);
  return best;
}

}  // namespace drydock::guess
