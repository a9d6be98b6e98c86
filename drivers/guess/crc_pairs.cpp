#include "drivers/guess/crc_pairs.hpp"

#include <algorithm>
#include <functional>

namespace drydock::guess {
namespace {

using wire::Bytes;

std::vector<std::uint8_t> difference_of(Bytes a, Bytes b) {
  std::vector<std::uint8_t> result(a.size());
  std::ranges::transform(a, b, result.begin(), std::bit_xor<>());
  return result;
}

/// The XOR of each two frames that follow each other among those of one length. Equal ones say
/// nothing.
std::vector<std::vector<std::uint8_t>> differences_of(const Frames& frames, std::size_t most) {
  std::vector<std::vector<std::uint8_t>> all;
  std::map<std::size_t, Bytes> waiting;  // by length
  for (const Bytes frame : frames) {
    if (all.size() == most) break;
    const auto [other, alone] = waiting.try_emplace(frame.size(), frame);
    if (alone || std::ranges::equal(other->second, frame)) continue;
    all.push_back(difference_of(other->second, frame));
    waiting.erase(other);
  }
  return all;
}

std::size_t first_difference(const std::vector<std::uint8_t>& bytes) {
  const auto at = std::ranges::find_if(bytes, [](std::uint8_t byte) { return byte != 0; });
  return static_cast<std::size_t>(at - bytes.begin());
}

}  // namespace

CrcPairs::CrcPairs(const Frames& frames) {
  auto all = differences_of(frames, at_once * rounds);
  if (all.size() < at_once * rounds) return;
  for (std::size_t i = 0; i < all.size(); i += at_once) {
    Three& three = threes_.emplace_back();
    std::move(all.begin() + static_cast<std::ptrdiff_t>(i),
              all.begin() + static_cast<std::ptrdiff_t>(i + at_once), three.differences.begin());
    three.first = first_difference(three.differences[0]);
    for (const auto& one : three.differences)
      three.first = std::min(three.first, first_difference(one));
  }
}

bool CrcPairs::allow(const Sum& sum) {
  return threes_.empty() ||
         std::ranges::any_of(threes_, [&](Three& three) { return allows(three, sum); });
}

bool CrcPairs::allows(Three& three, const Sum& sum) {
  Sum linear = sum;
  linear.checksum = sum.checksum.linear();
  linear.from = std::max(sum.from, three.first);  // zeros in front change nothing
  std::array<Bytes, at_once> bodies;
  std::ranges::transform(three.differences, bodies.begin(),
                         [&](Bytes difference) { return linear.covered(difference); });
  const auto [known, is_new] =
      three.sums.try_emplace({linear.checksum.polynomial(), linear.behind, linear.from});
  if (is_new) known->second = linear.checksum.of_three(bodies);
  for (std::size_t i = 0; i < at_once; ++i)
    for (const bool big : {false, true}) {
      linear.big_endian = big;
      if (three.differences[i].size() > sum.tail() &&
          linear.stored(three.differences[i]) == known->second[i])
        return true;
    }
  return false;
}

}  // namespace drydock::guess
