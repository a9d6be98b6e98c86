#include "drivers/guess/guess_numbers.hpp"

#include <algorithm>
#include <array>

namespace drydock::guess {
namespace {

using wire::Bytes;

/// The costs are those of these frames, one behind the other.
constexpr std::size_t most_weighed = 512;

bool counts(const Frames& frames, std::size_t at) {
  std::size_t steps = 0;
  for (std::size_t i = 1; i < frames.size(); ++i)
    steps += static_cast<std::uint8_t>(frames[i][at] - frames[i - 1][at]) == 1;
  return frames.size() > 1 && steps * 10 >= (frames.size() - 1) * 9;
}

struct NumberForm {
  std::size_t size = 1;
  bool is_real = false;

  bool operator==(const NumberForm&) const = default;
};

/// Floats come first: where integers take as many bits it is a float.
constexpr std::array<NumberForm, 6> number_forms{
    {{4, true}, {8, true}, {4, false}, {2, false}, {3, false}, {8, false}}};

/// Places in order, and the bits that they take together.
struct Layout {
  std::vector<NumberPlace> places;
  double bits = 0;
};

Layout best_layout(const Frames& frames, std::size_t from, const ByteCosts& bytes,
                   const std::vector<bool>& is_known, bool big_endian, NumberForm usual = {}) {
  const std::size_t end = bytes.bits.size();
  std::vector<double> bits(end + 1);    // from each byte to the end
  std::vector<NumberPlace> first(end);  // of the best layout from there
  std::size_t reach = 0;                // bytes up to the next known one
  for (std::size_t at = end; at-- > from;) {
    constexpr double bits_of_a_type = 8;
    reach = is_known[at] ? 0 : reach + 1;
    first[at] = {at};
    bits[at] = bits[at + 1];
    if (is_known[at]) continue;
    bits[at] += bytes.is_fixed[at] ? 0 : bytes.bits[at] + bits_of_a_type;
    for (const NumberForm form : number_forms) {
      if (form.size > reach) continue;
      const NumberPlace place{at, form.size, form.is_real, big_endian};
      const auto cost = number_cost(frames, place, bytes, form == usual);
      if (!cost || *cost + bits[at + form.size] >= bits[at]) continue;
      bits[at] = *cost + bits[at + form.size];
      first[at] = place;
    }
  }
  Layout best{{}, from < end ? bits[from] : 0};
  for (std::size_t at = from; at < end; at += first[at].size)
    if (!is_known[at]) best.places.push_back(first[at]);
  return best;
}

/// The form of most numbers; one byte: no two are alike.
NumberForm usual_form(const Layout& layout) {
  const auto times = [&](NumberForm form) {
    return std::ranges::count_if(layout.places, [&](const NumberPlace& place) {
      return NumberForm{place.size, place.is_real} == form;
    });
  };
  const NumberForm most = std::ranges::max(number_forms, {}, times);
  return times(most) > 1 ? most : NumberForm{};
}

/// Numbers of one frame are mostly of one form. So the layout is looked for twice.
Layout best_layout_of(const Frames& frames, std::size_t from, const ByteCosts& bytes,
                      const std::vector<bool>& is_known, bool big_endian) {
  const Layout first = best_layout(frames, from, bytes, is_known, big_endian);
  const NumberForm usual = usual_form(first);
  return usual.size == 1 ? first : best_layout(frames, from, bytes, is_known, big_endian, usual);
}

Guessed byte_at(const Frames& frames, std::size_t at) {
  const auto [low, high] = std::ranges::minmax(frames, {}, [&](Bytes f) { return f[at]; });
  Guessed one{.at = at, .low = double(low[at]), .high = double(high[at])};
  if (is_constant(frames, at))
    one.looks = Guessed::Looks::constant;
  else if (counts(frames, at))
    one.looks = Guessed::Looks::counter;
  return one;
}

Guessed real_at(const Frames& frames, const NumberPlace& place) {
  const auto value = [&](Bytes frame) { return place.real(frame); };
  const auto [low, high] = std::ranges::minmax(frames, {}, value);
  return {Guessed::Looks::number, place.at,   place.size, place.size == 4 ? "f32" : "f64",
          place.big_endian,       value(low), value(high)};
}

/// Without a sign where that makes the range shorter, and of a clock.
Guessed integer_at(const Frames& frames, const NumberPlace& place) {
  const auto with_sign = [&](Bytes frame) { return place.integer(frame); };
  const auto without = [&](Bytes frame) {
    return static_cast<std::uint64_t>(place.integer(frame)) & ~0ull >> (64 - 8 * place.size);
  };
  const auto [low, high] = std::ranges::minmax(frames, {}, with_sign);
  const auto [least, most] = std::ranges::minmax(frames, {}, without);
  const double range = static_cast<double>(with_sign(high)) - static_cast<double>(with_sign(low));
  const double plain_low = static_cast<double>(without(least)),
               plain_high = static_cast<double>(without(most));
  const bool is_plain = plain_high - plain_low < range ||
                        (place.size >= 4 && with_sign(low) >= 0 && is_clock(frames, place));
  constexpr std::array<std::string_view, 9> plain{"", "", "u16", "u24", "u32", "", "", "", "u64"},
      with{"", "", "i16", "i24", "i32", "", "", "", "i64"};
  return {Guessed::Looks::number,
          place.at,
          place.size,
          (is_plain ? plain : with)[place.size],
          place.big_endian,
          is_plain ? plain_low : static_cast<double>(with_sign(low)),
          is_plain ? plain_high : static_cast<double>(with_sign(high))};
}

}  // namespace

bool is_constant(const Frames& frames, std::size_t at) {
  const std::uint8_t first = frames[0][at];
  const auto same = std::ranges::count_if(frames, [&](Bytes f) { return f[at] == first; });
  return static_cast<std::size_t>(same) * 10 >= frames.size() * 9;
}

std::vector<Guessed> guess_numbers(const Frames& frames, std::size_t from, std::size_t end,
                                   const std::vector<std::size_t>& known) {
  const Frames some(frames.begin(),
                    frames.begin() + std::ptrdiff_t(std::min(frames.size(), most_weighed)));
  const ByteCosts bytes(some, end);
  std::vector<bool> is_known(end);
  for (const std::size_t at : known)
    if (at < end) is_known[at] = true;
  const Layout little = best_layout_of(some, from, bytes, is_known, false),
               big = best_layout_of(some, from, bytes, is_known, true);
  std::vector<Guessed> all;
  for (const NumberPlace& place : (big.bits < little.bits ? big : little).places)
    all.push_back(place.size == 1 ? byte_at(frames, place.at)
                  : place.is_real ? real_at(frames, place)
                                  : integer_at(frames, place));
  return all;
}

}  // namespace drydock::guess
