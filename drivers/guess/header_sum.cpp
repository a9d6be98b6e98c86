#include "drivers/guess/header_sum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace drydock::guess {
namespace {

using wire::Bytes;
using wire::described::Checksum;

constexpr std::size_t furthest_header_sum = 14, furthest_header = 4, fewest_with_header = 16,
                      fewest_header_sums = 8;

/// Plain sums: of the hundred CRCs one would fit by chance.
std::vector<Checksum> tried_checksums() {
  std::vector<Checksum> all;
  for (const std::string_view name :
       {"sum-8", "sum-8-negative", "sum-8-inverted", "xor", "sum-16", "sum-16-negative",
        "fletcher-16", "crc-8/smbus", "crc-16/ibm-3740", "crc-16/xmodem", "crc-16/modbus"})
    if (Checksum one; Checksum::find(name, one)) all.push_back(one);
  return all;
}

std::uint32_t stored_in(const HeaderSum& sum, Bytes frame) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < sum.checksum.size(); ++i)
    value = value << 8 | frame[sum.at + (sum.big_endian ? i : sum.checksum.size() - 1 - i)];
  return value;
}

bool is_proved(const HeaderSum& sum, const Frames& frames) {
  std::set<std::uint32_t> values;
  for (const Bytes frame : frames) {
    if (!sum.is_right(frame)) return false;
    values.insert(stored_in(sum, frame));
  }
  return values.size() >= fewest_header_sums;
}

/// Two bytes that change, at least: a number beside one that changes alone may follow it.
bool covers_changes(const HeaderSum& sum, const Frames& frames) {
  std::size_t changing = 0;
  for (std::size_t at = sum.from; at < sum.to; ++at)
    changing += std::ranges::any_of(frames, [&](Bytes f) { return f[at] != frames[0][at]; });
  return changing >= 2;
}

}  // namespace

bool HeaderSum::is_right(Bytes frame) const {
  return frame.size() >= at + checksum.size() &&
         checksum.of(frame.first(to).subspan(from)) == stored_in(*this, frame);
}

std::string HeaderSum::text() const {
  return fmt::format("header_checksum = {{ checksum = \"{}\", at = {}, from = {}, to = {} }}\n",
                     checksum.name(), at, from, to);
}

std::optional<HeaderSum> guess_header_sum(const BinaryGuess& guess) {
  if (guess.frames.size() < fewest_with_header) return {};
  const std::size_t tail = guess.sum ? guess.sum->tail() : 0;
  const std::size_t shortest = std::ranges::min(guess.frames, {}, &Bytes::size).size() - tail;
  for (const Checksum& checksum : tried_checksums())
    for (std::size_t at = guess.sync + 2;
         at + checksum.size() <= std::min(furthest_header_sum, shortest); ++at)
      for (std::size_t from = 0; from <= furthest_header && from + 2 <= at; ++from)
        for (const bool big : {false, true}) {
          if (big && checksum.size() == 1) continue;
          // A description has one order for both checksums.
          const bool has_order = guess.sum && guess.sum->checksum.size() > 1;
          if (has_order && checksum.size() > 1 && big != guess.sum->big_endian) continue;
          const HeaderSum sum{checksum, big, at, from, at};
          if (is_proved(sum, guess.frames) && covers_changes(sum, guess.frames)) return sum;
        }
  return {};
}

}  // namespace drydock::guess
