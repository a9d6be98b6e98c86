#include "drivers/wire/pgn_table/catalogue.hpp"

#include <algorithm>

#include "drivers/wire/pgn_table/bits.hpp"

namespace drydock::wire::pgn_table {
namespace {

bool fits(const Definition& definition, Bytes message) {
  return std::ranges::all_of(definition.fields, [&](const Field& field) {
    return !field.match || bits_at(message, field.bit_offset, field.bits) == field.match;
  });
}

bool is_of(const Definition& definition, std::uint64_t manufacturer) {
  return !definition.fields.empty() && definition.fields.front().match == manufacturer;
}

}  // namespace

Catalogue::Catalogue(const Table& table) : table_(table) {
  for (const Definition& definition : table.definitions)
    of_pgn_[definition.pgn].push_back(&definition);
}

std::optional<Travel> Catalogue::travel(std::uint32_t pgn) const {
  const auto found = of_pgn_.find(pgn);
  return found == of_pgn_.end() ? std::nullopt : std::optional(found->second.front()->travel);
}

const Definition* Catalogue::find(std::uint32_t pgn, Bytes message) const {
  const auto of_pgn = of_pgn_.find(pgn);
  if (of_pgn == of_pgn_.end()) return nullptr;
  const auto found = std::ranges::find_if(
      of_pgn->second, [&](const Definition* definition) { return fits(*definition, message); });
  return found == of_pgn->second.end() ? nullptr : *found;
}

const Field* Catalogue::field(std::uint32_t pgn, std::uint64_t number,
                              std::optional<std::uint64_t> manufacturer) const {
  const auto of_pgn = of_pgn_.find(pgn);
  if (of_pgn == of_pgn_.end() || number == 0) return nullptr;
  for (const Definition* definition : of_pgn->second) {
    if (manufacturer && !is_of(*definition, *manufacturer)) continue;
    return number <= definition->fields.size() ? &definition->fields[number - 1] : nullptr;
  }
  return nullptr;
}

}  // namespace drydock::wire::pgn_table
