#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "rig_config/toml/node.hpp"

/// Reads the values of keys in a checked table. An absent key changes nothing. `unit`: the factor
/// from the unit of the key to SI.
namespace drydock::rig_config {

inline constexpr double millisecond = 1e-3;

inline void read(const Node& table, const char* key, double& into, double unit = 1) {
  if (const Node* value = table.find(key)) into = value->number * unit;
}
inline void read(const Node& table, const char* key, bool& into) {
  if (const Node* value = table.find(key)) into = value->boolean;
}
inline void read(const Node& table, const char* key, std::string& into) {
  if (const Node* value = table.find(key)) into = value->text;
}
inline void read(const Node& table, const char* key, int& into) {
  if (const Node* value = table.find(key)) into = static_cast<int>(value->integer);
}
/// Three numbers, or one number for all axes.
inline void read(const Node& table, const char* key, std::array<double, 3>& into, double unit = 1) {
  const Node* value = table.find(key);
  if (!value) return;
  for (std::size_t i = 0; i < 3; ++i)
    into[i] = (value->kind == Node::Kind::array ? value->items[i].number : value->number) * unit;
}

/// "-z": sign, then axis.
inline void read_axis(const Node& table, const char* key, std::array<double, 3>& into) {
  const Node* axis = table.find(key);
  if (!axis) return;
  into = {};
  into.at(static_cast<std::size_t>(axis->text[1] - 'x')) = axis->text[0] == '-' ? -1 : 1;
}

inline std::optional<double> read_if(const Node& table, const char* key, double unit = 1) {
  const Node* value = table.find(key);
  return value ? std::optional{value->number * unit} : std::nullopt;
}

inline std::optional<bool> read_bool_if(const Node& table, const char* key) {
  const Node* value = table.find(key);
  return value ? std::optional{value->boolean} : std::nullopt;
}

/// The enumerator of the text at `key`. `names` are those of the schema, in the order of the
/// enumerators.
template <class Enum, std::size_t N>
Enum named(const Node& table, const std::array<const char*, N>& names, const char* key = "kind") {
  const auto found = std::ranges::find(names, table.find(key)->text);
  return static_cast<Enum>(found - names.begin());
}

}  // namespace drydock::rig_config
