#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace drydock::rig_config {

/// Line and column in the file, from 1.
struct Position {
  int line = 0, column = 0;
};

/// One value of a TOML file with its position, without types of the parser.
struct Node {
  struct Member;
  enum class Kind : std::uint8_t { boolean, integer, number, text, date_time, array, table };
  Kind kind = Kind::table;
  Position at;      ///< of the value
  Position key_at;  ///< of its key; inside an array: of the value

  bool boolean = false;
  std::int64_t integer = 0;  ///< date_time: nanoseconds of UTC since 1970
  double number = 0;         ///< set for an integer too
  std::string text;          ///< set for a date_time too, as RFC 3339
  std::vector<Node> items;
  std::vector<Member> members;

  const Node* find(std::string_view key) const;

  /// The text at `key`, or nullptr if the key is absent or its value is not a text.
  const Node* find_text(std::string_view key) const {
    const Node* value = find(key);
    return value && value->kind == Kind::text ? value : nullptr;
  }
};

struct Node::Member {
  std::string key;
  Node value;
};

inline const Node* Node::find(std::string_view key) const {
  for (const Member& member : members)
    if (member.key == key) return &member.value;
  return nullptr;
}

/// Visits each table of `[[key]]` with its index.
template <class Visit>
void for_each_table(const Node& root, std::string_view key, Visit&& visit) {
  const Node* array = root.find(key);
  if (!array) return;
  for (std::size_t i = 0; i < array->items.size(); ++i)
    if (array->items[i].kind == Node::Kind::table) visit(array->items[i], i);
}

}  // namespace drydock::rig_config
