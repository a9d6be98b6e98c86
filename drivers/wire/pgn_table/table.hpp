#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

/// What a file like canboat's canboat.json says about NMEA 2000: a definition for each PGN or for
/// each of its forms. Schema: canboat/canboat, docs/canboat.json (Apache-2.0).
namespace drydock::wire::pgn_table {

enum class FieldKind : std::uint8_t {
  number,  ///< raw * step + offset; also times and durations
  real,    ///< float of 32 bits
  lookup,
  indirect_lookup,  ///< its meaning depends on another field
  bit_lookup,       ///< each bit has a meaning
  date,             ///< days since 1970
  mmsi,
  name,              ///< NAME of a node, 64 bits
  fixed_text,        ///< padded
  text_with_length,  ///< length, text
  text_with_kind,    ///< length with this byte and the next, 0 UTF-16 or 1 UTF-8, text
  bytes,
  decimal,     ///< two digits a byte
  left_out,    ///< reserved, spare
  key,         ///< says which kind of value comes
  key_length,  ///< bytes of that value
  key_value,
  parameter,        ///< number of a field of the message's parameter PGN
  parameter_value,  ///< value of that field
};

inline constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

struct Field {
  std::string id, label_key, bits_key;  ///< keys of the value, its meaning, its bits' meanings
  FieldKind kind = FieldKind::number;
  std::uint16_t bits = 0;  ///< 0: as the message says, or all that is left
  double step = 1;
  double steps_per_unit = 0;     ///< 1 / step if that is whole, else 0
  std::optional<double> offset;  ///< then the raw number is unsigned
  bool is_signed = false;
  std::optional<double> lowest_raw;    ///< of a number with a sign whose range ends above its bits
  unsigned markers = 0;                ///< so many of the highest raw numbers are no values
  std::optional<std::uint64_t> match;  ///< raw number that makes a message one of this definition
  std::size_t bit_offset = 0;          ///< of a field with `match` or on which another depends
  std::size_t lookup = none;           ///< index in the table's list of its kind
  std::size_t other = none;     ///< index of the field that an indirect lookup or a length is of
  bool if_proprietary = false;  ///< only there if the parameter PGN is proprietary
};

/// Fields `first` to `first + size` come several times.
struct RepeatedFields {
  std::size_t first = 0, size = 0;
  std::size_t count = none;  ///< index of the field that says how often; none: to the end
};

enum class Travel : std::uint8_t { frame, fast_packet, transport };

struct Definition {
  std::uint32_t pgn = 0;
  std::string id;
  Travel travel = Travel::frame;
  std::vector<Field> fields;
  std::array<RepeatedFields, 2> sets;
};

using Lookup = std::unordered_map<std::uint64_t, std::string>;

/// A kind of value that a key announces.
struct KeyedField {
  std::string name;
  Field field;
};

struct Table {
  std::vector<Definition> definitions;  ///< in the file's order, without fallbacks
  std::vector<Lookup> lookups, bit_lookups;
  std::vector<std::map<std::pair<std::uint64_t, std::uint64_t>, std::string>> indirect_lookups;
  std::vector<std::unordered_map<std::uint64_t, KeyedField>> keyed;
  std::vector<std::string> missing_lookups;  ///< their fields are numbers without a label
  std::size_t fallbacks = 0;  ///< definitions that only say that nobody knows the PGN
};

}  // namespace drydock::wire::pgn_table
