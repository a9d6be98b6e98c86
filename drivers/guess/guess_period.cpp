#include <algorithm>
#include <set>
#include <tuple>

#include "drivers/guess/binary_guess.hpp"

/// Frames of one length, whose first byte never changes.
namespace drydock::guess {
namespace {

using wire::Bytes;

constexpr std::size_t shortest_period = 4, longest_period = 512, fewest_periods = 4;

/// Distances at which many bytes are equal.
struct Periods {
  std::size_t usual = 0;  ///< most bytes; 0: there is none
  /// What divides them too, the shortest first: where messages alternate, the length of one is a
  /// part of the distance.
  std::set<std::size_t> tried;
};

Periods periods_of(Bytes capture) {
  constexpr std::size_t most_lags = 4;
  std::vector<std::pair<std::size_t, std::size_t>> lags;  // bytes that are equal, the distance
  std::size_t most = 0;
  Periods found;
  const std::size_t limit = std::min(longest_period, capture.size() / fewest_periods);
  for (std::size_t lag = shortest_period; lag <= limit; ++lag) {
    std::size_t equal = 0;
    for (std::size_t i = 0; i + lag < capture.size(); ++i) equal += capture[i] == capture[i + lag];
    if (equal * 8 <= capture.size()) continue;
    lags.emplace_back(equal, lag);
    if (equal <= most + most / 50) continue;  // a multiple of a period is no better
    found.usual = lag;
    most = equal;
  }
  std::ranges::stable_sort(lags, std::ranges::greater{}, [](const auto& lag) { return lag.first; });
  lags.resize(std::min(lags.size(), most_lags));
  if (found.usual > 0) lags.emplace_back(most, found.usual);
  for (const auto& [equal, lag] : lags)
    for (std::size_t part = shortest_period; part <= lag; ++part)
      if (lag % part == 0) found.tried.insert(part);
  return found;
}

/// Those places of the first periods that hold the same byte nearly always.
std::vector<bool> still_places(Bytes capture, std::size_t period) {
  constexpr std::size_t enough = 32;  // behind a byte that was lost every place is another one
  capture = capture.first(std::min(capture.size(), enough * period));
  std::vector<bool> still(period);
  for (std::size_t phase = 0; phase < period; ++phase) {
    std::size_t same = 0, all = 0;
    for (std::size_t at = phase; at < capture.size(); at += period, ++all)
      same += capture[at] == capture[phase];
    still[phase] = same * 2 > all;
  }
  return still;
}

/// Frames that begin with the same byte, as the next one does.
Frames cut_at(Bytes capture, std::size_t phase, std::size_t length) {
  Frames frames;
  const auto begins = [&](std::size_t at) {
    return at >= capture.size() || capture[at] == capture[phase];
  };
  for (std::size_t at = phase; at + length <= capture.size();) {
    const bool synced = begins(at) && begins(at + length);
    if (synced) frames.push_back(capture.subspan(at, length));
    at += synced ? length : 1;
  }
  return frames;
}

/// Frames with a right checksum, wherever they are.
Frames right_frames(Bytes capture, std::uint8_t sync, std::size_t length, const Sum& sum) {
  Frames frames;
  for (std::size_t at = 0; at + length <= capture.size();) {
    const Bytes frame = capture.subspan(at, length);
    const bool right = frame[0] == sync && sum.is_right(frame);
    if (right) frames.push_back(frame);
    at += right ? length : 1;
  }
  return frames;
}

BinaryGuess guess_at(Bytes capture, std::size_t phase, std::size_t length) {
  BinaryGuess guess{1, {}, {}, cut_at(capture, phase, length)};
  if (guess.frames.size() < fewest_periods) return {};
  guess.sum = guess_checksum(guess.frames);
  if (guess.sum) guess.frames = right_frames(capture, capture[phase], length, *guess.sum);
  return guess;
}

/// Bytes that begin no frame, but end many: CR, LF, ETX.
bool is_usual_end(std::uint8_t byte) { return byte == '\r' || byte == '\n' || byte == 0x03; }

/// Bytes at the head that never change, up to the first that does. Zeros are no sync.
std::size_t head_of_frames(const BinaryGuess& guess) {
  std::size_t head = 0;
  while (head < guess.frames[0].size() && guess.frames[0][head] != 0 &&
         is_constant(guess.frames, head))
    ++head;
  return head;
}

/// A checksum right in every frame is right too where a constant byte stands at the other end of
/// it: a frame has few bytes that its checksum leaves out, and most captures begin with one.
bool is_better_phase(const BinaryGuess& a, const BinaryGuess& b) {
  if (a.sum.has_value() != b.sum.has_value()) return a.sum.has_value();
  const std::size_t edge = a.sum ? 2 : 0;  // at both ends of a capture a frame may be cut
  if (a.frames.size() > b.frames.size() + edge || b.frames.size() > a.frames.size() + edge)
    return a.frames.size() > b.frames.size();
  if (!a.sum) return head_of_frames(a) > head_of_frames(b);
  const auto rank = [](const BinaryGuess& g) {
    return std::tuple(g.sum->from + g.sum->behind, is_usual_end(g.frames[0][0]), ~g.frames.size(),
                      g.sum->behind);
  };
  return rank(a) < rank(b);
}

std::optional<BinaryGuess> best_phase(Bytes capture, std::size_t period) {
  // Before the first byte stand the checksum, which changes, and few that do not.
  constexpr std::size_t furthest = 4;
  const auto still = still_places(capture, period);
  std::optional<BinaryGuess> best;
  for (std::size_t phase = 0; phase < period && phase + period < capture.size(); ++phase) {
    std::size_t before = 0;
    while (before <= furthest && still[(phase + furthest * period - before) % period]) ++before;
    if (before == 0 || (before > furthest && phase > 0)) continue;
    BinaryGuess guess = guess_at(capture, phase, period);
    if (guess.frames.size() < fewest_periods) continue;
    if (!best || is_better_phase(guess, *best)) best = std::move(guess);
  }
  return best;
}

/// Many more bytes; of two periods that explain as much the first, which is shorter, counts.
bool explains_more(const BinaryGuess& a, const BinaryGuess& b) {
  return a.bytes() > b.bytes() + b.bytes() / 50;
}

/// Where bytes were lost at the beginning, the places of its second half may tell more.
std::optional<BinaryGuess> best_of_halves(Bytes capture, std::size_t period) {
  auto first = best_phase(capture, period);
  if (first && first->sum) return first;
  auto second = best_phase(capture.subspan(capture.size() / 2), period);
  if (!second || !second->sum) return first;
  second->frames = right_frames(capture, second->frames[0][0], period, *second->sum);
  return second;
}

/// The same in all of the capture.
BinaryGuess in_all(Bytes capture, BinaryGuess guess) {
  const Bytes first = guess.frames[0];
  guess.frames =
      guess.sum
          ? right_frames(capture, first[0], first.size(), *guess.sum)
          : cut_at(capture, static_cast<std::size_t>(first.data() - capture.data()), first.size());
  const bool alike = std::ranges::all_of(
      guess.frames, [&](Bytes frame) { return frame[1] == guess.frames[0][1]; });
  guess.sync = alike ? 2 : 1;
  return guess;
}

}  // namespace

std::optional<BinaryGuess> guess_period(Bytes all) {
  constexpr std::size_t enough = 1u << 18;
  const Bytes capture = all.first(std::min(all.size(), enough));
  const Periods periods = periods_of(capture);
  std::optional<BinaryGuess> best, without_sum;
  for (const std::size_t period : periods.tried) {
    auto guess = best_of_halves(capture, period);
    if (!guess) continue;
    if (guess->sum && guess->bytes() * 4 > capture.size()) {
      if (!best || explains_more(*guess, *best)) best = std::move(guess);
    } else if (period == periods.usual) {
      guess->sum.reset();
      without_sum = std::move(guess);
    }
  }
  if (!best) best = std::move(without_sum);
  return best ? std::optional(in_all(all, std::move(*best))) : std::nullopt;
}

}  // namespace drydock::guess
