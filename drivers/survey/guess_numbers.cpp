#include "drivers/survey/guess_numbers.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "drivers/wire/bytes.hpp"

namespace drydock::survey {
namespace {

using wire::Bytes;

bool counts(const Frames& frames, std::size_t at) {
  std::size_t steps = 0;
  for (std::size_t i = 1; i < frames.size(); ++i)
    steps += static_cast<std::uint8_t>(frames[i][at] - frames[i - 1][at]) == 1;
  return frames.size() > 1 && steps * 10 >= (frames.size() - 1) * 9;
}

struct Range {
  double low = 0, high = 0, step = 0;  ///< step: mean change from frame to frame
};

template <class T>
double value_at(Bytes frame, std::size_t at, bool big) {
  return static_cast<double>(big ? wire::load_be<T>(frame, at) : wire::load_le<T>(frame, at));
}

template <class T>
Range range_of(const Frames& frames, std::size_t at, bool big) {
  const double first = value_at<T>(frames[0], at, big);
  Range range{first, first, 0};
  double before = first;
  for (const Bytes frame : frames) {
    const double value = value_at<T>(frame, at, big);
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
    range.step += std::abs(value - before) / static_cast<double>(frames.size());
    before = value;
  }
  return range;
}

/// A float of a sensor is finite and of a usual size; noise about zero comes near it now and then.
template <class T>
bool is_real(const Frames& frames, std::size_t at, bool big) {
  std::size_t tiny = 0;
  for (const Bytes frame : frames) {
    const double x = value_at<T>(frame, at, big);
    if (!std::isfinite(x) || std::abs(x) >= 1e7) return false;
    tiny += x != 0 && std::abs(x) <= 1e-6;
  }
  return 100 * tiny <= frames.size();
}

constexpr std::size_t fewest_for_clock = 4;

/// A clock advances by nearly the same from frame to frame. Its upper half changes too, or is 0.
bool is_clock(const Frames& frames, std::size_t at, bool big) {
  const auto value = [&](Bytes frame) {
    return big ? wire::load_be<std::uint32_t>(frame, at) : wire::load_le<std::uint32_t>(frame, at);
  };
  if (frames.size() < fewest_for_clock) return false;
  std::vector<std::uint32_t> steps;
  bool small = true;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    steps.push_back(value(frames[i]) - value(frames[i - 1]));
    small = small && value(frames[i]) <= 0xFFFF;
  }
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::ranges::nth_element(steps, middle);
  const std::uint32_t usual = *middle;
  if (usual == 0 || usual > 0x1000000) return false;
  const auto even = std::ranges::count_if(
      steps, [&](std::uint32_t step) { return step - (usual - usual / 8) <= usual / 4; });
  const bool upper_changes = usual > 0xFFFF / steps.size();
  return static_cast<std::size_t>(even) * 10 >= steps.size() * 9 && (small || upper_changes);
}

/// A small number of 16 bits with a sign: its upper byte is 0 or FFh, as its lower one tells.
bool is_small_signed(const Frames& frames, std::size_t at, bool big) {
  std::size_t negative = 0;
  for (const Bytes frame : frames) {
    const std::uint8_t upper = frame[big ? at : at + 1], lower = frame[big ? at + 1 : at];
    if (upper != (lower >= 0x80 ? 0xFF : 0)) return false;
    negative += upper != 0;
  }
  return 100 * std::min(negative, frames.size() - negative) >= frames.size();
}

bool is_smooth(const Range& range) {
  return range.high > range.low && range.step < (range.high - range.low) / 4;
}

/// Four bytes are one integer, not two, if the lower half alone jumps where the whole does not.
bool is_long(const Frames& frames, std::size_t at, bool big) {
  const Range whole = range_of<std::int32_t>(frames, at, big);
  const Range low = range_of<std::uint16_t>(frames, big ? at + 2 : at, big);
  return whole.high - whole.low > 0xFFFF && is_smooth(whole) && !is_smooth(low);
}

template <class T>
std::optional<Guessed> number(const Frames& frames, std::size_t at, std::size_t end,
                              std::string_view type,
                              bool (*is_one)(const Frames&, std::size_t, bool)) {
  if (at + sizeof(T) > end) return {};
  for (const bool big : {false, true}) {
    if (!is_one(frames, at, big)) continue;
    const Range range = range_of<T>(frames, at, big);
    if (range.high > range.low)
      return Guessed{Guessed::Looks::number, at, sizeof(T), type, big, range.low, range.high};
  }
  return {};
}

bool is_short(const Frames& frames, std::size_t at, bool big) {
  const Range range = range_of<std::int16_t>(frames, at, big);
  return is_smooth(range) && range.high - range.low > 255;
}

/// The shorter comes first: half of a double is seldom a float, but two floats are often a double.
std::optional<Guessed> number_at(const Frames& frames, std::size_t at, std::size_t end) {
  auto found = number<float>(frames, at, end, "f32", is_real<float>);
  if (!found) found = number<std::uint32_t>(frames, at, end, "u32", is_clock);
  if (!found) found = number<double>(frames, at, end, "f64", is_real<double>);
  if (!found) found = number<std::int16_t>(frames, at, end, "i16", is_small_signed);
  if (!found) found = number<std::int16_t>(frames, at, end, "i16", is_short);
  if (!found) found = number<std::int32_t>(frames, at, end, "i32", is_long);
  return found;
}

Guessed byte_at(const Frames& frames, std::size_t at) {
  const Range range = range_of<std::uint8_t>(frames, at, false);
  Guessed one{.at = at, .low = range.low, .high = range.high};
  if (is_constant(frames, at))
    one.looks = Guessed::Looks::constant;
  else if (counts(frames, at))
    one.looks = Guessed::Looks::counter;
  return one;
}

/// Behind a float with its high byte first comes another one, whose high byte does not change where
/// the value hardly does: gravity.
std::optional<Guessed> next_float(const Frames& frames, std::size_t at, std::size_t end,
                                  const Guessed& before) {
  const bool follows = before.type == "f32" && before.big_endian && frames[0][at] != 0;
  if (!follows || at + 4 > end || is_constant(frames, at + 3)) return {};
  if (!is_real<float>(frames, at, true)) return {};
  const Range range = range_of<float>(frames, at, true);
  return Guessed{Guessed::Looks::number, at, 4, "f32", true, range.low, range.high};
}

}  // namespace

bool is_constant(const Frames& frames, std::size_t at) {
  const std::uint8_t first = frames[0][at];
  const auto same = std::ranges::count_if(frames, [&](Bytes f) { return f[at] == first; });
  return static_cast<std::size_t>(same) * 10 >= frames.size() * 9;
}

std::vector<Guessed> guess_numbers(const Frames& frames, std::size_t from, std::size_t end) {
  std::vector<Guessed> all;
  for (std::size_t at = from; at < end; at += all.back().size) {
    Guessed one = byte_at(frames, at);
    if (one.looks == Guessed::Looks::constant && !all.empty())
      if (const auto next = next_float(frames, at, end, all.back())) one = *next;
    if (one.looks == Guessed::Looks::byte)
      if (const auto number = number_at(frames, at, end)) one = *number;
    all.push_back(one);
  }
  return all;
}

}  // namespace drydock::survey
