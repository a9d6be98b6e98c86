#include "drivers/wire/pgn_table/content.hpp"

#include <fmt/format.h>

#include <bit>
#include <chrono>
#include <cmath>

#include "drivers/wire/pgn_table/bits.hpp"
#include "drivers/wire/pgn_table/text.hpp"

namespace drydock::wire::pgn_table {
namespace {

std::optional<std::uint64_t> raw_of(const Field& field, const Slice& slice) {
  if (slice.bits < field.bits) return {};
  return bits_at(slice.bytes, slice.first_bit, field.bits);
}

/// A marker of the highest numbers is not a value, and none is below the field's range.
bool is_value(const Field& field, std::uint64_t raw) {
  const bool is_signed = field.is_signed && !field.offset;
  if (field.lowest_raw && is_signed &&
      static_cast<double>(with_sign(raw, field.bits)) < *field.lowest_raw)
    return false;
  const std::uint64_t top = highest(field.bits, is_signed);
  return raw > top || top - raw >= field.markers;
}

bool is_whole(const Field& field) { return field.step == 1 && !field.offset; }

void put_number(const Field& field, std::uint64_t raw, Value& value) {
  const bool is_signed = field.is_signed && !field.offset;
  const std::int64_t number = is_signed ? with_sign(raw, field.bits) : 0;
  if (is_whole(field)) {
    if (is_signed)
      value.content = number;
    else
      value.content = raw;
    return;
  }
  const double steps = is_signed ? static_cast<double>(number) : static_cast<double>(raw);
  const double scaled =
      field.steps_per_unit > 0 ? steps / field.steps_per_unit : steps * field.step;
  value.content = scaled + field.offset.value_or(0);
}

void put_meaning(const Lookup& lookup, std::uint64_t raw, Value& value) {
  const auto found = lookup.find(raw);
  if (found != lookup.end()) value.meaning = Name{found->second};
}

void put_bits(const Lookup& lookup, const Field& field, std::uint64_t raw, Value& value) {
  value.bits.emplace();
  for (std::uint64_t bit = 0; bit < field.bits; ++bit) {
    if ((raw >> bit & 1) == 0) continue;
    const auto found = lookup.find(bit);
    if (found != lookup.end()) value.bits->push_back(Name{found->second});
  }
}

std::string date_text(std::uint64_t days_since_1970) {
  using namespace std::chrono;
  const year_month_day date{sys_days{days{days_since_1970}}};
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
}

void put_real(std::uint64_t raw, Value& value) {
  const auto number = std::bit_cast<float>(static_cast<std::uint32_t>(raw));
  if (std::isfinite(number)) value.content = static_cast<double>(number);
}

Extent read_number(const Table& table, const Field& field, const Slice& slice,
                   std::optional<std::uint64_t> other) {
  Extent extent;
  extent.bits = field.bits;
  extent.value.has_meaning =
      field.kind == FieldKind::lookup || field.kind == FieldKind::indirect_lookup;
  const auto raw = raw_of(field, slice);
  if (!raw) return extent;
  Value& value = extent.value;
  if (field.kind == FieldKind::lookup) put_meaning(table.lookups[field.lookup], *raw, value);
  if (!is_value(field, *raw) && !value.meaning) return extent;
  extent.raw = raw;
  switch (field.kind) {
    case FieldKind::date: value.content = Text{date_text(*raw)}; break;
    case FieldKind::mmsi: value.content = Text{fmt::format("{:09}", *raw)}; break;
    case FieldKind::name: value.content = Text{fmt::format("{:016X}", *raw)}; break;
    case FieldKind::real: put_real(*raw, value); break;
    default: put_number(field, *raw, value);
  }
  if (field.kind == FieldKind::bit_lookup)
    put_bits(table.bit_lookups[field.lookup], field, *raw, value);
  if (field.kind == FieldKind::indirect_lookup && other) {
    const auto& meanings = table.indirect_lookups[field.lookup];
    const auto found = meanings.find({*other, *raw});
    if (found != meanings.end()) value.meaning = Name{found->second};
  }
  return extent;
}

}  // namespace

Extent read(const Table& table, const Field& field, const Slice& slice,
            std::optional<std::uint64_t> other) {
  switch (field.kind) {
    case FieldKind::fixed_text: return read_fixed_text(slice);
    case FieldKind::text_with_length: return read_text_with_length(slice);
    case FieldKind::text_with_kind: return read_text_with_kind(slice);
    case FieldKind::decimal: return read_decimal(slice);
    case FieldKind::bytes: return read_bytes(slice);
    case FieldKind::left_out: {
      Extent nothing;
      nothing.bits = std::min<std::size_t>(field.bits > 0 ? field.bits : all_left, slice.bits);
      return nothing;
    }
    default: return read_number(table, field, slice, other);
  }
}

}  // namespace drydock::wire::pgn_table
