#include "drivers/decode/pgn_table_file.hpp"

#include <algorithm>
#include <set>

#include "drivers/decode/pgn_field_reader.hpp"

namespace drydock::decode {
namespace {

using wire::pgn_table::Definition;
using wire::pgn_table::Field;
using wire::pgn_table::none;
using wire::pgn_table::Table;
using wire::pgn_table::Travel;

constexpr std::size_t most_definitions = 4096, most_fields = 256, most_lookups = 4096,
                      most_values = 65536, longest_text = 512;
constexpr std::uint64_t highest_pgn = 0x3FFFF;

void read_values(const JsonPlace& lookup, const char* list, const char* number,
                 wire::pgn_table::Lookup& values) {
  lookup.at(list).each(most_values, [&](const JsonPlace& value) {
    values[value.at(number).whole(0, ~std::uint64_t{0})] = value.at("Name").text(longest_text);
  });
}

/// Calls `take(entry)` for each lookup of the list, if the file has it, and notes its place.
template <class Take>
void each_lookup(const JsonPlace& file, const char* list, std::map<std::string, std::size_t>& index,
                 Take&& take) {
  const auto found = file.find(list);
  if (!found) return;
  found->each(most_lookups, [&](const JsonPlace& lookup) {
    const JsonPlace name = lookup.at("Name");
    if (!index.emplace(name.text(longest_text), index.size()).second)
      name.refuse("this name is used twice");
    take(lookup);
  });
}

PgnLookupIndex read_lookups(const JsonPlace& file, Table& table) {
  PgnLookupIndex index;
  each_lookup(file, "LookupEnumerations", index.plain, [&](const JsonPlace& lookup) {
    read_values(lookup, "EnumValues", "Value", table.lookups.emplace_back());
  });
  each_lookup(file, "LookupBitEnumerations", index.bits, [&](const JsonPlace& lookup) {
    read_values(lookup, "EnumBitValues", "Bit", table.bit_lookups.emplace_back());
  });
  each_lookup(file, "LookupIndirectEnumerations", index.indirect, [&](const JsonPlace& lookup) {
    auto& values = table.indirect_lookups.emplace_back();
    lookup.at("EnumValues").each(most_values, [&](const JsonPlace& value) {
      const auto first = value.at("Value1").whole(0, ~std::uint64_t{0});
      const auto second = value.at("Value2").whole(0, ~std::uint64_t{0});
      values[{first, second}] = value.at("Name").text(longest_text);
    });
  });
  each_lookup(file, "LookupFieldTypeEnumerations", index.keyed, [&](const JsonPlace& lookup) {
    auto& values = table.keyed.emplace_back();
    lookup.at("EnumFieldTypeValues").each(most_values, [&](const JsonPlace& value) {
      values[value.at("value").whole(0, ~std::uint64_t{0})] = {value.at("name").text(longest_text),
                                                               read_keyed_field(value, index)};
    });
  });
  return index;
}

Travel read_travel(const JsonPlace& place) {
  const std::string& type = place.text(longest_text);
  if (type == "Single") return Travel::frame;
  if (type == "Fast") return Travel::fast_packet;
  if (type == "ISO") return Travel::transport;
  place.refuse(fmt::format("unknown Type \"{}\", allowed: Single, Fast, ISO", type));
}

void read_set(const JsonPlace& place, const char* number, Definition& definition,
              wire::pgn_table::RepeatedFields& set) {
  const auto key = [&](const char* what) {
    return fmt::format("RepeatingFieldSet{}{}", number, what);
  };
  const auto size = place.find(key("Size").c_str());
  if (!size) return;
  const std::size_t fields = definition.fields.size();
  set.first = place.at(key("StartField").c_str()).whole(1, std::max<std::size_t>(fields, 1)) - 1;
  set.size = size->whole(1, fields - set.first);
  if (const auto count = place.find(key("CountField").c_str()))
    set.count = count->whole(1, set.first) - 1;
}

/// Fields have their places one behind the other, as long as their lengths are fixed.
void set_places(const JsonPlace& place, const std::vector<std::optional<std::size_t>>& told,
                Definition& definition) {
  std::size_t at = 0;
  bool is_fixed = true;
  for (std::size_t i = 0; i < definition.fields.size(); ++i) {
    Field& field = definition.fields[i];
    if (is_fixed && told[i].value_or(at) != at)
      place.refuse(fmt::format("{} has BitOffset {}, but the fields before it have {} bits",
                               field.id, *told[i], at));
    if (!is_fixed && field.match)
      place.refuse(field.id + " has a Match behind a field of any length");
    field.bit_offset = is_fixed ? at : none;
    is_fixed = is_fixed && field.bits > 0;
    at += field.bits;
  }
}

/// Makes indices of the numbers from 1.
void set_others(const JsonPlace& place, Definition& definition) {
  for (Field& field : definition.fields) {
    const std::size_t number = std::exchange(field.other, none);
    if (number == 0) continue;
    if (number > definition.fields.size())
      place.refuse(fmt::format("{} depends on field {}, the last is {}", field.id, number,
                               definition.fields.size()));
    field.other = number - 1;
    const Field& other = definition.fields[field.other];
    const bool needs_place = field.kind == wire::pgn_table::FieldKind::indirect_lookup;
    if (other.bits < 1 || other.bits > 64 || (needs_place && other.bit_offset == none))
      place.refuse(
          fmt::format("{} depends on {}, which is no number in a fixed place", field.id, other.id));
  }
}

Definition read_definition(const JsonPlace& place, PgnLookupIndex& lookups) {
  Definition definition;
  definition.pgn = static_cast<std::uint32_t>(place.at("PGN").whole(0, highest_pgn));
  definition.id = read_pgn_id(place.at("Id"));
  definition.travel = read_travel(place.at("Type"));
  std::vector<std::optional<std::size_t>> told;
  std::set<std::string> ids{"list", "list2"};
  const auto take = [&](const JsonPlace& field) {
    definition.fields.push_back(read_pgn_field(field, lookups));
    if (!ids.insert(definition.fields.back().id).second) field.at("Id").refuse("this Id is taken");
    const auto offset = field.find("BitOffset");
    told.push_back(offset ? std::optional<std::size_t>(offset->whole(0, 8 * 1785)) : std::nullopt);
  };
  if (const auto fields = place.find("Fields")) fields->each(most_fields, take);
  read_set(place, "1", definition, definition.sets[0]);
  read_set(place, "2", definition, definition.sets[1]);
  set_places(place, told, definition);
  set_others(place, definition);
  return definition;
}

void check_travel(const JsonPlace& place, const Definition& definition,
                  std::map<std::uint32_t, Travel>& travels) {
  const auto [known, added] = travels.emplace(definition.pgn, definition.travel);
  if (known->second != definition.travel)
    place.refuse("this PGN has another Type above, so its frames could be read in two ways");
}

void read_definitions(const JsonPlace& file, PgnLookupIndex& lookups, Table& table) {
  std::map<std::uint32_t, Travel> travels;
  file.at("PGNs").each(most_definitions, [&](const JsonPlace& place) {
    const auto fallback = place.find("Fallback");
    if (fallback && fallback->is_true()) {
      ++table.fallbacks;
      return;
    }
    table.definitions.push_back(read_definition(place, lookups));
    check_travel(place, table.definitions.back(), travels);
  });
  if (table.definitions.empty()) file.at("PGNs").refuse("no definitions");
}

std::string at_most(std::size_t bytes) {
  return fmt::format("the file has more than {} bytes", bytes);
}

}  // namespace

boost::system::result<Table, PgnTableProblem> read_pgn_table(std::string_view text) {
  if (text.size() > longest_pgn_table) return PgnTableProblem{at_most(longest_pgn_table)};
  try {
    const auto document = nlohmann::json::parse(text);
    Table table;
    const JsonPlace file(document, "");
    PgnLookupIndex lookups = read_lookups(file, table);
    read_definitions(file, lookups, table);
    table.missing_lookups.assign(lookups.missing.begin(), lookups.missing.end());
    return table;
  } catch (const nlohmann::json::parse_error& error) {
    return PgnTableProblem{std::string("not JSON: ") + error.what()};
  } catch (const JsonRefusal& refusal) {
    return PgnTableProblem{refusal.text};
  }
}

}  // namespace drydock::decode
