#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/wire/bit_field.hpp"
#include "drivers/wire/bytes.hpp"
#include "drivers/wire/codec.hpp"
#include "drivers/wire/j1939/j1939.hpp"

/// A message whose layout is data: `layout(message, field)` calls `field(key, value, place)` for
/// each value in order. The same statement decodes, encodes and prints, so that they cannot differ.
namespace drydock::wire::nmea2000 {

constexpr Resolution ones{1, 1}, tenth{1, 10}, hundredth{1, 100}, thousandth{1, 1000};
constexpr Resolution hundreds{100, 1};
constexpr Resolution angle_step{1, 10'000};  ///< rad

/// A number without a scale: `value` of type optional<Raw>.
struct Whole {
  std::size_t at;
};

/// `raw * step`, of an integer of type Raw. Values below `least` are not possible, and so empty.
template <class Raw>
struct Scaled {
  std::size_t at;
  Resolution step;
  double least = std::numeric_limits<double>::lowest();
  double most = std::numeric_limits<double>::max();
};

/// `width` bits from bit `shift` of one byte. Of 4 bits and more the two highest values are no
/// numbers, of fewer only the highest.
struct Bits {
  std::size_t at;
  unsigned shift, width;

  constexpr unsigned mask() const { return (1U << width) - 1; }
  constexpr unsigned first_reserved() const { return width >= 4 ? mask() - 1 : mask(); }
};

/// Bits of the 16 that begin with this byte, low byte first. The three highest values are no
/// numbers.
struct WordBits {
  std::size_t at;
  unsigned shift, width;

  constexpr unsigned mask() const { return (1U << width) - 1; }
};

/// Days since 1970 (16 bits) and then 1e-4 s of the day (32 bits), as nanoseconds since 1970.
struct DayTime {
  std::size_t at;
};
constexpr std::int64_t day_ns = 86400LL * 1'000'000'000, day_time_step_ns = 100'000;

/// Reads a payload as far as it goes: a value that is not there is empty.
class FieldReader {
 public:
  explicit FieldReader(Bytes payload) : payload_(payload) {}

  template <class Raw>
  void operator()(std::string_view, std::optional<Raw>& value, Whole place) const {
    const auto raw = load<Raw>(place.at);
    value = raw ? number_field(*raw) : std::nullopt;
  }
  template <class Raw>
  void operator()(std::string_view, std::optional<double>& value, Scaled<Raw> place) const {
    const auto raw = load<Raw>(place.at);
    value = raw ? scaled_field(*raw, place.step) : std::nullopt;
    if (value && (*value < place.least || *value > place.most)) value.reset();
  }
  void operator()(std::string_view, std::optional<std::uint8_t>& value, Bits place) const {
    const auto raw = load<std::uint8_t>(place.at);
    const unsigned bits = raw.value_or(0xFF) >> place.shift & place.mask();
    value.reset();
    if (bits < place.first_reserved()) value = static_cast<std::uint8_t>(bits);
  }
  void operator()(std::string_view, std::optional<std::uint16_t>& value, WordBits place) const {
    const auto raw = load<std::uint16_t>(place.at);
    const unsigned bits = raw.value_or(0xFFFF) >> place.shift & place.mask();
    value.reset();
    if (bits + 3 <= place.mask()) value = static_cast<std::uint16_t>(bits);
  }
  void operator()(std::string_view, std::optional<std::int64_t>& value, DayTime place) const {
    std::optional<std::uint16_t> days;
    std::optional<std::uint32_t> steps;
    (*this)({}, days, Whole{place.at});
    (*this)({}, steps, Whole{place.at + 2});
    value.reset();
    if (days && steps) value = *days * day_ns + *steps * day_time_step_ns;
  }

 private:
  template <class Raw>
  std::optional<Raw> load(std::size_t at) const {
    if (payload_.size() < at + sizeof(Raw)) return std::nullopt;
    return load_le<Raw>(payload_, at);
  }

  Bytes payload_;
};

/// Writes into bytes that are all 0xFF. What stands behind them is not written.
class FieldWriter {
 public:
  explicit FieldWriter(std::span<std::uint8_t> payload) : payload_(payload) {}

  template <class Raw>
  void operator()(std::string_view, const std::optional<Raw>& value, Whole place) const {
    if (has(place.at, sizeof(Raw)))
      store_le<Raw>(payload_, place.at, value.value_or(Sentinels<Raw>::not_available));
  }
  template <class Raw>
  void operator()(std::string_view, const std::optional<double>& value, Scaled<Raw> place) const {
    if (has(place.at, sizeof(Raw)))
      store_le<Raw>(payload_, place.at, to_scaled_field<Raw>(value, place.step));
  }
  void operator()(std::string_view, const std::optional<std::uint8_t>& value, Bits place) const {
    if (!has(place.at, 1)) return;
    const unsigned bits = value.value_or(place.mask()) & place.mask();
    const unsigned others = payload_[place.at] & ~(place.mask() << place.shift);
    payload_[place.at] = static_cast<std::uint8_t>(others | bits << place.shift);
  }
  void operator()(std::string_view, const std::optional<std::uint16_t>& value,
                  WordBits place) const {
    if (!has(place.at, 2)) return;
    const unsigned bits = value.value_or(place.mask()) & place.mask();
    const unsigned others =
        load_le<std::uint16_t>(payload_, place.at) & ~(place.mask() << place.shift);
    store_le<std::uint16_t>(payload_, place.at,
                            static_cast<std::uint16_t>(others | bits << place.shift));
  }
  void operator()(std::string_view, const std::optional<std::int64_t>& value, DayTime place) const {
    std::optional<std::uint16_t> days;
    std::optional<std::uint32_t> steps;
    if (value) {
      days = static_cast<std::uint16_t>(*value / day_ns);
      steps = static_cast<std::uint32_t>(*value % day_ns / day_time_step_ns);
    }
    (*this)({}, days, Whole{place.at});
    (*this)({}, steps, Whole{place.at + 2});
  }

 private:
  bool has(std::size_t at, std::size_t size) const { return at + size <= payload_.size(); }

  std::span<std::uint8_t> payload_;
};

/// The message's type says where it stands on the bus and how much of it must be there.
template <class M>
concept LaidOut = requires(M& m, FieldReader reader) {
  { M::pgn } -> std::convertible_to<std::uint32_t>;
  { M::priority } -> std::convertible_to<std::uint8_t>;
  { M::bytes } -> std::convertible_to<std::size_t>;  ///< more than 8: a fast packet
  { M::least } -> std::convertible_to<std::size_t>;  ///< bytes up to its first value
  M::layout(m, reader);
};

/// Empty if the payload ends before the message's first value. Calls `correct` of a message that
/// has values which exclude each other.
template <LaidOut M>
std::optional<M> decode(std::uint8_t source, Bytes payload) {
  if (payload.size() < M::least) return std::nullopt;
  M message;
  message.source = source;
  M::layout(message, FieldReader(payload));
  if constexpr (requires { message.correct(); }) message.correct();
  return message;
}

/// A value beyond the range of the wire is sent as "out of range", an empty value as "not
/// available".
template <LaidOut M>
void encode_payload(const M& message, std::span<std::uint8_t, M::bytes> out) {
  std::ranges::fill(out, std::uint8_t{0xFF});
  M::layout(message, FieldWriter(out));
}

template <LaidOut M>
constexpr bool is_fast = M::bytes > 8;

template <class M>
constexpr j1939::Identifier identifier_of(const M& message) {
  return {M::priority, M::pgn, j1939::global_address, message.source};
}

template <LaidOut M>
requires(!is_fast<M>) CanFrame encode(const M& message) {
  CanFrame frame = j1939::blank_frame(identifier_of(message));
  M::layout(message, FieldWriter(frame.data));
  return frame;
}

template <LaidOut M, class Field>
void visit_fields(const M& m, Field&& field) {
  field("source", m.source);
  M::layout(m, [&](std::string_view key, const auto& value, const auto&) { field(key, value); });
}

}  // namespace drydock::wire::nmea2000
