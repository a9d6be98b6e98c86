#include "drivers/guess/guess_checksum.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>

namespace drydock::guess {
namespace {

using wire::Bytes;
using wire::described::Checksum;

constexpr std::size_t most_checked = 256;
/// Behind the sync come at most a class, an identifier and a length that a CRC leaves out. A sum of
/// the payload alone leaves out a count or a time too.
constexpr std::size_t furthest_start = 4, furthest_start_of_sum = 12;
constexpr std::size_t most_behind = 2;  ///< CR LF, ETX

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
  constexpr std::size_t fewest_values = 3;
  std::set<std::uint32_t> values;
  std::size_t wrong = 0, seen = 0;
  for (const Bytes frame : frames) {
    const auto value = sum.right_in(frame);
    wrong += !value;
    if (value) values.insert(*value);
    // Three wrong ones at the beginning are hardly all damaged.
    if (wrong * 10 > frames.size() || (++seen == 3 && wrong == 3)) return {};
  }
  return values.size() >= fewest_values ? std::optional(wrong) : std::nullopt;
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

std::optional<std::uint32_t> Sum::right_in(Bytes frame) const {
  const std::size_t size = checksum.size();
  if (frame.size() < from + size + behind + 1) return {};
  const Bytes body = frame.first(frame.size() - tail()).subspan(from);
  const Bytes stored = frame.subspan(at.value_or(from + body.size()), size);
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < size; ++i) value = value << 8 | stored[big_endian ? i : size - 1 - i];
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
    for (std::size_t at = first; at <= furthest_in_front; ++at)
      for (std::size_t between = 0; between <= most_between; ++between)
        for (const bool big : {false, true})
          if (!big || checksum.size() > 1)
            best.take({checksum, big, at + checksum.size() + between, 0, at});
  }
  return best.sum;
}

}  // namespace

std::optional<Sum> guess_checksum(const Frames& frames) {
  const Frames some = some_of(frames);
  BestSum best{some};
  for (std::size_t behind = 0; behind <= most_behind; ++behind) {
    if (!end_alike(frames, behind)) continue;
    for (const Checksum& checksum : all_checksums())
      for (std::size_t from = 0;
           from <= (checksum.is_crc() ? furthest_start : furthest_start_of_sum); ++from)
        for (const bool big : {false, true}) {
          if (big && checksum.size() == 1) continue;
          best.take({checksum, big, from, behind});
          if (best.fewest == 0) return best.sum;
        }
  }
  return best.sum ? best.sum : guess_sum_in_front(some);
}

std::string hex_of(Bytes bytes) { return fmt::format("{:02X}", fmt::join(bytes, " ")); }

}  // namespace drydock::guess
