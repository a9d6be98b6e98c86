#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/pgn_table/table.hpp"

namespace drydock::wire::pgn_table {

/// Finds the definition of a message. Keeps a reference to the table.
class Catalogue {
 public:
  explicit Catalogue(const Table& table);

  /// How messages of this PGN travel; empty: it is not in the table.
  std::optional<Travel> travel(std::uint32_t pgn) const;
  /// The first definition of the PGN whose fixed fields are those of the message; null: none.
  const Definition* find(std::uint32_t pgn, Bytes message) const;
  /// Field `number` (from 1) of the PGN, of a message of this manufacturer if it has several forms;
  /// null: none.
  const Field* field(std::uint32_t pgn, std::uint64_t number,
                     std::optional<std::uint64_t> manufacturer) const;
  const Table& table() const { return table_; }

 private:
  const Table& table_;
  std::unordered_map<std::uint32_t, std::vector<const Definition*>> of_pgn_;
};

/// PGNs whose content makers decide.
constexpr bool is_proprietary(std::uint64_t pgn) {
  return pgn == 61184 || pgn == 126720 || (pgn >= 65280 && pgn <= 65535) ||
         (pgn >= 130816 && pgn <= 131071);
}

}  // namespace drydock::wire::pgn_table
