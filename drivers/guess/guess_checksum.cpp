#include "drivers/guess/guess_checksum.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>

#include "drivers/guess/crc_pairs.hpp"

namespace drydock::guess {
namespace {

using wire::Bytes;
using wire::described::Checksum;

constexpr std::size_t most_checked = 256;
/// Behind the sync come at most a class, an identifier and a length that a CRC leaves out. A sum of
/// the payload alone leaves out a count or a time too.
constexpr std::size_t furthest_start = 4, furthest_start_of_sum = 12;
constexpr std::size_t most_behind = 2;  ///< CR LF, ETX
constexpr std::size_t enough_frames = 3;

const std::vector<Checksum>& all_checksums() {
  static const auto all = [] {
    std::vector<Checksum> made;
    for (const std::string_view name : wire::described::checksum_names())
      if (Checksum one; Checksum::find(name, one) && one.size() > 0) made.push_back(one);
    return made;
  }();
  return all;
}

/// Frames with another checksum; empty: too many. Frames that do not change prove none.
std::optional<std::size_t> wrong_frames(const Sum& sum, std::span<const Bytes> frames) {
  std::set<std::uint32_t> values;
  std::size_t wrong = 0, seen = 0;
  for (const Bytes frame : frames) {
    const auto value = sum.right_in(frame);
    wrong += !value;
    if (value) values.insert(*value);
    // Three wrong ones at the beginning are hardly all damaged.
    if (wrong * 10 > frames.size() || (++seen == enough_frames && wrong == seen)) return {};
  }
  return values.size() >= enough_frames ? std::optional(wrong) : std::nullopt;
}

bool end_alike(const Frames& frames, std::size_t behind) {
  const Bytes end = frames[0].last(std::min(behind, frames[0].size()));
  return std::ranges::all_of(frames, [&](Bytes frame) {
    return frame.size() >= behind && std::ranges::equal(frame.last(end.size()), end);
  });
}

/// From all of the capture: a count that begins with FF 01 adds nothing to a sum for a while.
Frames some_of(const Frames& frames) {
  if (frames.size() <= most_checked) return frames;
  Frames some;
  for (std::size_t i = 0; i < most_checked; ++i)
    some.push_back(frames[i * frames.size() / most_checked]);
  return some;
}

}  // namespace

Bytes Sum::covered(Bytes frame) const {
  if (frame.size() < from + checksum.size() + behind + 1) return {};
  return frame.first(frame.size() - tail()).subspan(from);
}

std::uint32_t Sum::stored(Bytes frame) const {
  const std::size_t size = checksum.size();
  const Bytes bytes = frame.subspan(at.value_or(frame.size() - tail()), size);
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < size; ++i) value = value << 8 | bytes[big_endian ? i : size - 1 - i];
  return value;
}

std::optional<std::uint32_t> Sum::right_in(Bytes frame) const {
  const Bytes body = covered(frame);
  if (body.empty()) return {};
  const std::uint32_t value = stored(frame);
  return checksum.of(body) == value ? std::optional(value) : std::nullopt;
}

namespace {

/// Keeps the sum that is wrong least often.
struct BestSum {
  const Frames& frames;
  std::optional<Sum> sum{};
  std::size_t fewest = frames.size();

  void take(const Sum& one) {
    const auto wrong = wrong_frames(one, frames);
    if (!wrong || *wrong >= fewest) return;
    sum = one;
    fewest = *wrong;
  }

  /// With its low byte first, then last. Nearly all are wrong in the first three frames: these are
  /// summed once for both.
  void take_both(Sum& one) {
    const std::array first{frames[0], frames[1], frames[2]};
    std::array<Bytes, 3> bodies;
    std::ranges::transform(first, bodies.begin(), [&](Bytes frame) { return one.covered(frame); });
    const auto sums = one.checksum.of_three(bodies);
    for (const bool big : {false, true}) {
      one.big_endian = big;
      bool any = false;
      for (std::size_t k = 0; k < first.size(); ++k)
        any = any || (!bodies[k].empty() && one.stored(first[k]) == sums[k]);
      if (any) take(one);
      if (one.checksum.size() == 1 || fewest == 0) return;
    }
  }
};

/// Right in nine of ten frames by chance is one of hundred CRCs sooner than a plain sum. The wider
/// ones come first: the low byte of a sum of 16 bits is one of 8 bits.
std::optional<Sum> guess_sum_in_front(const Frames& some) {
  constexpr std::size_t first = 1, furthest_in_front = 8, most_between = 2;
  BestSum best{some};
  std::vector<Checksum> plain;
  std::ranges::copy_if(all_checksums(), std::back_inserter(plain), std::not_fn(&Checksum::is_crc));
  std::ranges::stable_sort(plain, std::ranges::greater{}, &Checksum::size);
  for (const Checksum& checksum : plain) {
    Sum one{.checksum = checksum};
    for (one.at = first; *one.at <= furthest_in_front; ++*one.at)
      for (std::size_t between = 0; between <= most_between; ++between) {
        one.from = *one.at + checksum.size() + between;
        best.take_both(one);
      }
  }
  return best.sum;
}

}  // namespace

std::optional<Sum> guess_checksum(const Frames& frames) {
  if (frames.size() < enough_frames) return {};
  const Frames some = some_of(frames);
  BestSum best{some};
  CrcPairs pairs(some);
  for (std::size_t behind = 0; behind <= most_behind; ++behind) {
    if (!end_alike(frames, behind)) continue;
    for (const Checksum& checksum : all_checksums()) {
      const std::size_t furthest = checksum.is_crc() ? furthest_start : furthest_start_of_sum;
      for (Sum one{.checksum = checksum, .behind = behind}; one.from <= furthest; ++one.from) {
        if (checksum.is_crc() && !pairs.allow(one)) continue;
        best.take_both(one);
        if (best.fewest == 0) return best.sum;
      }
    }
  }
  return best.sum ? best.sum : guess_sum_in_front(some);
}

std::string hex_of(Bytes bytes) { return fmt::format("{:02X}", fmt::join(bytes, " ")); }

}  // namespace drydock::guess
