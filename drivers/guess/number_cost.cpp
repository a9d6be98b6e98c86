#include "drivers/guess/number_cost.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "drivers/guess/code_length.hpp"
#include "drivers/wire/bytes.hpp"

namespace drydock::guess {
namespace {

using wire::Bytes;

constexpr double bits_of_a_byte = 8;

/// The bits of values that are told by their middle, by the one before, or by a straight line
/// through the two before: the way that takes fewest. `digits`: of the distance between two.
template <class T, class Digits>
double fewest_bits(const std::vector<T>& values, Digits digits) {
  std::vector<T> sorted = values;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::ranges::nth_element(sorted, middle);
  std::array<std::vector<std::uint8_t>, 3> ways;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const T before = values[i < 1 ? i : i - 1], first = values[i < 2 ? 0 : i - 2];
    ways[0].push_back(digits(values[i], *middle));
    ways[1].push_back(digits(values[i], before));
    ways[2].push_back(digits(values[i], static_cast<T>(before + before - first)));
  }
  double fewest = bits_of_residuals(ways[0]);
  for (const auto& way : ways) fewest = std::min(fewest, bits_of_residuals(way));
  return fewest;
}

std::int64_t with_sign(std::uint64_t value, std::size_t size) {
  const std::size_t unused = 64 - 8 * std::clamp<std::size_t>(size, 1, 8);
  return static_cast<std::int64_t>(value << unused) >> unused;
}

/// The bits of values of which each came before, but for a few. Empty: they are many.
std::optional<double> bits_by_memory(const Frames& frames, const NumberPlace& place) {
  constexpr std::size_t most = 64;
  std::map<std::int64_t, std::uint8_t> known;
  std::vector<std::uint8_t> symbols;
  for (const Bytes frame : frames) {
    const auto number = static_cast<std::uint8_t>(known.size());
    symbols.push_back(known.emplace(place.integer(frame), number).first->second);
    if (known.size() > most) return {};
  }
  const double of_a_byte = place.is_real ? 7 : bits_of_a_byte;  // most floats are no usual ones
  return bits_of_symbols(symbols, of_a_byte * static_cast<double>(place.size));
}

double integer_bits(const Frames& frames, const NumberPlace& place) {
  std::vector<std::uint64_t> values;
  for (const Bytes frame : frames)
    values.push_back(static_cast<std::uint64_t>(place.integer(frame)) ^ 1ull << 63);
  const auto digits = [&](std::uint64_t a, std::uint64_t b) {
    return binary_digits(std::abs(static_cast<double>(with_sign(a - b, place.size))));
  };
  const double all = static_cast<double>(8 * place.size * frames.size());
  return std::min(fewest_bits(values, digits), all);
}

/// In units of the last place that a great value has. Low bytes that never change tell nothing.
double real_bits(const Frames& frames, const NumberPlace& place, std::size_t fixed_low_bytes) {
  std::vector<double> values, sizes;
  for (const Bytes frame : frames) {
    values.push_back(place.real(frame));
    sizes.push_back(std::abs(values.back()));
  }
  const auto ninth = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() * 9 / 10);
  std::ranges::nth_element(sizes, ninth);
  const double great = *ninth > 0 ? *ninth : std::ranges::max(sizes);
  const int digits_behind = place.size == 4 ? 23 : 52;
  const double unit =
      std::ldexp(1.0, std::ilogb(great) - digits_behind + 8 * static_cast<int>(fixed_low_bytes));
  double bits = fewest_bits(values, [&](double a, double b) {
    return binary_digits(std::round(std::abs(a - b) / unit));
  });
  // A smaller value has more digits behind those.
  for (const double x : values)
    if (x != 0) bits += std::max(0, std::ilogb(great) - std::ilogb(x));
  return bits;
}

/// A float of a sensor is finite and of a usual size; noise about zero comes near it now and then.
bool looks_real(const Frames& frames, const NumberPlace& place) {
  std::size_t tiny = 0;
  for (const Bytes frame : frames) {
    const double x = place.real(frame);
    if (!std::isfinite(x) || std::abs(x) >= 1e7) return false;
    tiny += x != 0 && std::abs(x) <= 1e-6;
  }
  return 100 * tiny <= frames.size();
}

}  // namespace

std::int64_t NumberPlace::integer(Bytes frame) const {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i)
    value = value << 8 | frame[big_endian ? at + i : at + size - 1 - i];
  return with_sign(value, size);
}

double NumberPlace::real(Bytes frame) const {
  if (size == 4)
    return big_endian ? wire::load_be<float>(frame, at) : wire::load_le<float>(frame, at);
  return big_endian ? wire::load_be<double>(frame, at) : wire::load_le<double>(frame, at);
}

ByteCosts::ByteCosts(const Frames& all, std::size_t end)
    : bits(end), is_fixed(end), frames(static_cast<double>(all.size())) {
  std::vector<std::uint8_t> values(all.size());
  for (std::size_t at = 0; at < end; ++at) {
    std::ranges::transform(all, values.begin(), [&](Bytes frame) { return frame[at]; });
    is_fixed[at] = std::ranges::count(values, values[0]) == std::ssize(values);
    if (is_fixed[at]) continue;
    bits[at] = std::min(bits_of_symbols(values, bits_of_a_byte), integer_bits(all, {at}));
  }
}

bool is_clock(const Frames& frames, const NumberPlace& place) {
  constexpr std::size_t fewest = 4;
  if (frames.size() < fewest) return false;
  std::vector<std::uint64_t> steps;
  for (std::size_t i = 1; i < frames.size(); ++i)
    steps.push_back(static_cast<std::uint64_t>(place.integer(frames[i])) -
                    static_cast<std::uint64_t>(place.integer(frames[i - 1])));
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::ranges::nth_element(steps, middle);
  const std::uint64_t usual = *middle, longest = place.size == 4 ? 0x1000000 : 0x1000000000;
  if (usual == 0 || usual > longest) return false;
  const auto even = std::ranges::count_if(
      steps, [&](std::uint64_t step) { return step - (usual - usual / 8) <= usual / 4; });
  return static_cast<std::size_t>(even) * 10 >= steps.size() * 9;
}

std::optional<double> number_cost(const Frames& frames, const NumberPlace& place,
                                  const ByteCosts& bytes, bool is_usual) {
  std::size_t changing = 0, white = 0, fixed_low = 0, fixed_high = 0;
  const auto is_fixed = [&](std::size_t from_low) {
    return bytes
        .is_fixed[place.big_endian ? place.least_significant() - from_low : place.at + from_low];
  };
  for (std::size_t at = place.at; at < place.at + place.size; ++at) {
    changing += !bytes.is_fixed[at];
    white += at != place.most_significant() && bytes.is_white(at);
  }
  if (changing < 2) return {};
  while (is_fixed(fixed_low)) ++fixed_low;
  while (is_fixed(place.size - 1 - fixed_high)) ++fixed_high;
  // Of an integer no byte stands still between two that do not.
  if (!place.is_real && fixed_low + changing + fixed_high < place.size) return {};
  const std::size_t top = place.most_significant();
  const bool clock = !place.is_real && place.size >= 4 && is_clock(frames, place);
  // The highest byte changes, but for a clock that is young, and gravity among accelerations.
  const bool may_be_fixed = is_usual || (clock && frames[0][top] == 0);
  if (!place.is_real && (place.size == 8 ? !clock : bytes.is_fixed[top] && !may_be_fixed))
    return {};
  if (place.is_real && !looks_real(frames, place)) return {};
  // What tells the type: less than that of its bytes one by one where it is a special one.
  double bits = bits_of_a_byte * static_cast<double>(changing) + (place.is_real || clock ? -1 : 1) -
                (is_usual ? 2 : 0);
  const double each =
      place.is_real ? real_bits(frames, place, fixed_low) : integer_bits(frames, place);
  bits += std::min(each, bits_by_memory(frames, place).value_or(each));
  // A byte that nothing foretells is no value by itself.
  constexpr double bonus = 0.25;
  const double least = bytes.bits[place.least_significant()];
  if (bytes.bits[top] + bytes.frames <= least)
    bits -= bonus * bytes.frames * static_cast<double>(white);
  return bits;
}

}  // namespace drydock::guess
