#include "drivers/wire/dbc/plan.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "drivers/wire/dbc/bits.hpp"

namespace drydock::wire::dbc {

namespace {

std::int64_t sign_extended(std::uint64_t raw, unsigned bits) {
  const unsigned unused = (64 - bits) & 63;  // a signal has at least one bit
  return static_cast<std::int64_t>(raw << unused) >> unused;
}

/// Integers of fewer than 64 bits get the sign of their number.
std::uint64_t extended(std::uint64_t raw, const Layout& layout) {
  if (layout.number != Number::signed_integer) return raw;
  return static_cast<std::uint64_t>(sign_extended(raw, layout.bits));
}

double as_number(std::uint64_t raw, Number number) {
  switch (number) {
    case Number::unsigned_integer: return static_cast<double>(raw);
    case Number::signed_integer: return static_cast<double>(static_cast<std::int64_t>(raw));
    case Number::float32: return std::bit_cast<float>(static_cast<std::uint32_t>(raw));
    case Number::float64: return std::bit_cast<double>(raw);
  }
  return 0;
}

Value value_of(std::uint64_t raw, const Layout& layout) {
  return {raw, as_number(raw, layout.number) * layout.factor + layout.offset, true};
}

/// The raw integer nearest to a number. Empty if the signal has no bits for it.
std::optional<std::uint64_t> to_integer(double number, const Layout& layout) {
  const bool is_signed = layout.number == Number::signed_integer;
  const double limit = std::ldexp(1.0, static_cast<int>(layout.bits - (is_signed ? 1 : 0)));
  const double whole = std::round(number);
  if (!(whole >= (is_signed ? -limit : 0) && whole < limit)) return std::nullopt;
  return is_signed ? static_cast<std::uint64_t>(static_cast<std::int64_t>(whole))
                   : static_cast<std::uint64_t>(whole);
}

std::optional<std::uint64_t> to_raw(double number, const Layout& layout) {
  switch (layout.number) {
    case Number::float32: return std::bit_cast<std::uint32_t>(static_cast<float>(number));
    case Number::float64: return std::bit_cast<std::uint64_t>(number);
    default: return to_integer(number, layout);
  }
}

}  // namespace

Plan::Plan(const Message& message) {
  for (const Signal& signal : message.signals) {
    Field field{signal.layout, signal.layout.bytes_needed(), -1,
                static_cast<std::uint32_t>(ranges_.size()), 0};
    if (signal.selected_by) field.selector = static_cast<std::int32_t>(*signal.selected_by);
    field.ranges = static_cast<std::uint32_t>(signal.when.size());
    ranges_.insert(ranges_.end(), signal.when.begin(), signal.when.end());
    fields_.push_back(field);
  }
}

bool Plan::selected(const Field& field, std::span<const Value> values) const {
  if (field.selector < 0) return true;
  const Value& selector = values[static_cast<std::size_t>(field.selector)];
  const auto raw = static_cast<std::int64_t>(selector.raw);
  const auto when = std::span(ranges_).subspan(field.first_range, field.ranges);
  return selector.present &&
         std::ranges::any_of(when, [&](const Range& range) { return range.has(raw); });
}

void Plan::decode(Bytes payload, std::span<Value> values) const {
  const bool short_enough = payload.size() <= 8;
  const PayloadWord word(short_enough ? payload : Bytes{});
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const Field& field = fields_[i];
    values[i] = {};
    if (field.bytes_needed > payload.size() || !selected(field, values)) continue;
    const std::uint64_t raw =
        short_enough ? word.bits(field.layout) : load_bits(payload, field.layout);
    values[i] = value_of(extended(raw, field.layout), field.layout);
  }
}

void Plan::encode(std::span<Value> values, std::span<std::uint8_t> payload) const {
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const Field& field = fields_[i];
    values[i].present = field.bytes_needed <= payload.size() && selected(field, values);
    if (values[i].present) store_bits(payload, field.layout, values[i].raw);
  }
}

std::optional<Value> Plan::nearest(std::size_t signal, double physical) const {
  const Layout& layout = fields_[signal].layout;
  const auto raw = to_raw((physical - layout.offset) / layout.factor, layout);
  if (!raw) return std::nullopt;
  return value_of(*raw, layout);
}

}  // namespace drydock::wire::dbc
