#pragma once

#include <map>
#include <set>
#include <string>

#include "drivers/decode/json_place.hpp"
#include "drivers/wire/pgn_table/table.hpp"

namespace drydock::decode {

/// Where the lookups of a table stand in its lists, by name.
struct PgnLookupIndex {
  std::map<std::string, std::size_t> plain, bits, indirect, keyed;
  std::set<std::string> missing{};  ///< that fields name and the file does not have
};

/// Reads an entry of `Fields`. `other` still counts fields from 1, and is 0 without one. A field of
/// a lookup that the file does not have is a number without a label. Throws JsonRefusal.
wire::pgn_table::Field read_pgn_field(const JsonPlace& place, PgnLookupIndex& lookups);

/// Reads the field that a key announces: an entry of `EnumFieldTypeValues`.
wire::pgn_table::Field read_keyed_field(const JsonPlace& place, PgnLookupIndex& lookups);

/// An Id is a key of the output: letters, digits and _.
std::string read_pgn_id(const JsonPlace& place);

}  // namespace drydock::decode
