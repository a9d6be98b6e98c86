#include "drivers/decode/pgn_field_reader.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/wire/pgn_table/bits.hpp"

namespace drydock::decode {
namespace {

using wire::pgn_table::Field;
using wire::pgn_table::FieldKind;

constexpr std::size_t longest_name = 256;
constexpr unsigned longest_field_bits = 8 * 1785;  ///< J1939's transport protocol carries no more

struct NamedKind {
  std::string_view name;
  FieldKind kind;
};

constexpr NamedKind field_types[] = {
    {"NUMBER", FieldKind::number},
    {"DURATION", FieldKind::number},
    {"TIME", FieldKind::number},
    {"PGN", FieldKind::number},
    {"FLOAT", FieldKind::real},
    {"LOOKUP", FieldKind::lookup},
    {"INDIRECT_LOOKUP", FieldKind::indirect_lookup},
    {"BITLOOKUP", FieldKind::bit_lookup},
    {"DATE", FieldKind::date},
    {"MMSI", FieldKind::mmsi},
    {"ISO_NAME", FieldKind::name},
    {"STRING_FIX", FieldKind::fixed_text},
    {"STRING_LZ", FieldKind::text_with_length},
    {"STRING_LAU", FieldKind::text_with_kind},
    {"BINARY", FieldKind::bytes},
    {"DECIMAL", FieldKind::decimal},
    {"RESERVED", FieldKind::left_out},
    {"SPARE", FieldKind::left_out},
    {"DYNAMIC_FIELD_KEY", FieldKind::key},
    {"DYNAMIC_FIELD_LENGTH", FieldKind::key_length},
    {"DYNAMIC_FIELD_VALUE", FieldKind::key_value},
    {"FIELD_INDEX", FieldKind::parameter},
    {"VARIABLE", FieldKind::parameter_value},
};

bool is_number(FieldKind kind) {
  switch (kind) {
    case FieldKind::fixed_text:
    case FieldKind::text_with_length:
    case FieldKind::text_with_kind:
    case FieldKind::bytes:
    case FieldKind::decimal:
    case FieldKind::left_out:
    case FieldKind::key_value:
    case FieldKind::parameter_value: return false;
    default: return true;
  }
}

FieldKind read_kind(const JsonPlace& place) {
  const std::string& name = place.text(longest_name);
  const auto known = std::ranges::find(field_types, name, &NamedKind::name);
  if (known != std::end(field_types)) return known->kind;
  std::string allowed;
  for (const NamedKind& kind : field_types) {
    if (!allowed.empty()) allowed += ", ";
    allowed += kind.name;
  }
  place.refuse(fmt::format("unknown FieldType \"{}\", allowed: {}", name, allowed));
}

void read_step(const JsonPlace& place, Field& field) {
  field.step = place.number();
  if (!(std::isfinite(field.step) && field.step > 0)) place.refuse("expected more than 0");
  const double per_unit = std::round(1 / field.step);
  if (field.step < 1 && std::abs(per_unit * field.step - 1) < 1e-9) field.steps_per_unit = per_unit;
}

/// A subset of a file may leave lookups out: their values remain numbers.
std::size_t find_lookup(const JsonPlace& place, const std::map<std::string, std::size_t>& known,
                        PgnLookupIndex& lookups, Field& field) {
  const auto found = known.find(place.text(longest_name));
  if (found != known.end()) return found->second;
  lookups.missing.insert(place.text(longest_name));
  field.kind = FieldKind::number;
  return wire::pgn_table::none;
}

void read_lookup(const JsonPlace& place, PgnLookupIndex& lookups, Field& field) {
  using enum FieldKind;
  const auto find = [&](const char* key, const std::map<std::string, std::size_t>& known) {
    return find_lookup(place.at(key), known, lookups, field);
  };
  switch (field.kind) {
    case lookup: field.lookup = find("LookupEnumeration", lookups.plain); break;
    case bit_lookup: field.lookup = find("LookupBitEnumeration", lookups.bits); break;
    case key: {
      const JsonPlace name = place.at("LookupFieldTypeEnumeration");
      const auto found = lookups.keyed.find(name.text(longest_name));
      if (found == lookups.keyed.end()) name.refuse("no such lookup in the file");
      field.lookup = found->second;
      break;
    }
    case indirect_lookup:
      field.lookup = find("LookupIndirectEnumeration", lookups.indirect);
      if (field.kind == indirect_lookup)
        field.other = place.at("LookupIndirectEnumerationFieldOrder").whole(1, 256);
      break;
    default: break;
  }
}

/// Fields of 8 bits and more keep three numbers for what is no value, of 4 bits two, of 2 bits one.
/// Where the highest value of the file is just below the highest number, that decides.
unsigned markers_of(const Field& field, std::optional<double> highest_value) {
  if (field.kind == FieldKind::bit_lookup || field.kind == FieldKind::real) return 0;
  const bool is_signed = field.is_signed && !field.offset;
  const auto top = static_cast<double>(wire::pgn_table::highest(field.bits, is_signed));
  if (highest_value && field.bits < 48) {
    const double raw = std::round((*highest_value - field.offset.value_or(0)) / field.step);
    if (raw <= top && raw >= top - 3) return static_cast<unsigned>(top - raw);
  }
  return field.bits >= 8 ? 3 : field.bits >= 4 ? 2 : field.bits >= 2 ? 1 : 0;
}

/// A file gives every number the range of its bits without the lowest one, where nothing else is
/// known: that one is then a value all the same, as canboat has it.
std::optional<double> lowest_raw_of(const Field& field, double lowest_value) {
  if (field.kind != FieldKind::number || !field.is_signed || field.offset) return {};
  const double raw = std::round(lowest_value / field.step);
  const double of_the_bits = -std::ldexp(1.0, static_cast<int>(field.bits) - 1);
  return raw > of_the_bits + 1 ? std::optional(raw) : std::nullopt;
}

void read_number(const JsonPlace& place, Field& field) {
  if (const auto step = place.find("Resolution")) read_step(*step, field);
  if (const auto sign = place.find("Signed")) field.is_signed = sign->is_true();
  if (const auto offset = place.find("Offset")) field.offset = offset->number();
  std::optional<double> highest_value;
  if (const auto range = place.find("RangeMax")) highest_value = range->number();
  field.markers = markers_of(field, highest_value);
  if (const auto range = place.find("RangeMin"))
    field.lowest_raw = lowest_raw_of(field, range->number());
}

void check_bits(const JsonPlace& place, const Field& field) {
  if (is_number(field.kind) && (field.bits < 1 || field.bits > 64))
    place.refuse("BitLength of a number must be 1 to 64");
  if (field.is_signed && field.bits < 2) place.refuse("a number with a sign has at least 2 bits");
  if (field.kind == FieldKind::real && field.bits != 32) place.refuse("a FLOAT has 32 bits");
  if (field.kind == FieldKind::date && field.bits > 16) place.refuse("a DATE has at most 16 bits");
}

void set_keys(std::string id, Field& field) {
  field.label_key = id + "_label";
  field.bits_key = id + "_bits";
  field.id = std::move(id);
}

}  // namespace

std::string read_pgn_id(const JsonPlace& place) {
  const std::string& id = place.text(longest_name);
  const bool good = !id.empty() && std::ranges::all_of(id, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
  if (!good) place.refuse("expected letters, digits and _");
  return id;
}

Field read_pgn_field(const JsonPlace& place, PgnLookupIndex& lookups) {
  Field field;
  set_keys(read_pgn_id(place.at("Id")), field);
  field.kind = read_kind(place.at("FieldType"));
  field.other = 0;
  if (const auto bits = place.find("BitLength"))
    field.bits = static_cast<std::uint16_t>(bits->whole(1, longest_field_bits));
  if (is_number(field.kind)) read_number(place, field);
  check_bits(place, field);
  read_lookup(place, lookups, field);
  if (const auto length = place.find("BitLengthField")) field.other = length->whole(1, 256);
  if (const auto match = place.find("Match")) field.match = match->whole(0, ~std::uint64_t{0});
  if (const auto condition = place.find("Condition")) {
    if (condition->text(longest_name) != "PGNIsProprietary")
      condition->refuse("unknown condition, allowed: PGNIsProprietary");
    field.if_proprietary = true;
  }
  return field;
}

Field read_keyed_field(const JsonPlace& place, PgnLookupIndex& lookups) {
  Field field;
  field.kind = read_kind(place.at("FieldType"));
  field.other = 0;
  const JsonPlace bits = place.at("Bits");
  const std::string& digits = bits.text(longest_name);
  const bool good = !digits.empty() && digits.size() < 6 &&
                    std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
  const unsigned long count = good ? std::stoul(digits) : 0;
  if (count < 1 || count > longest_field_bits) bits.refuse("expected a number of bits as text");
  field.bits = static_cast<std::uint16_t>(count);
  if (is_number(field.kind)) read_number(place, field);
  check_bits(place, field);
  read_lookup(place, lookups, field);
  if (field.kind == FieldKind::indirect_lookup) place.refuse("a key announces no INDIRECT_LOOKUP");
  return field;
}

}  // namespace drydock::decode
