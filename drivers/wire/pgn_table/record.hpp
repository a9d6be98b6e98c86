#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "drivers/wire/pgn_table/table.hpp"

namespace drydock::wire::pgn_table {

struct Text {
  std::string utf8;
};
/// A name in the table.
struct Name {
  std::string_view utf8;
};

/// A value in the table's unit. Views point into the table.
struct Value {
  const Field* field = nullptr;
  std::variant<std::monostate, std::int64_t, std::uint64_t, double, Text> content;
  bool has_meaning = false;
  std::optional<Name> meaning;              ///< of a lookup; empty: not in the table
  std::optional<std::vector<Name>> bits{};  ///< of a bit lookup: those that are set
};

struct Record {
  std::vector<Value> values;
  std::array<std::vector<Record>, 2> sets;  ///< fields that come several times
};

struct Message {
  const Definition* definition = nullptr;
  Record record;
  bool cut_short = false;  ///< it ended within a field, or before one of its fields
};

template <class F>
void visit_fields(const Record& record, F&& field) {
  for (const Value& v : record.values) {
    const auto put = [&](const auto& content) {
      if constexpr (std::is_same_v<std::decay_t<decltype(content)>, std::monostate>)
        field(v.field->id, std::optional<double>());
      else
        field(v.field->id, content);
    };
    std::visit(put, v.content);
    if (v.has_meaning) field(v.field->label_key, v.meaning);
    if (v.bits) field(v.field->bits_key, std::span{*v.bits});
  }
  if (!record.sets[0].empty()) field("list", std::span{record.sets[0]});
  if (!record.sets[1].empty()) field("list2", std::span{record.sets[1]});
}

}  // namespace drydock::wire::pgn_table
