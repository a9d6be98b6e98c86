#include "rig_config/toml/with_estimator.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "rig_config/estimator/kinds.hpp"
#include "rig_config/toml/split_values.hpp"

namespace drydock::rig_config {

namespace {

std::string text_at(const toml::table& table, std::string_view key) {
  return table[key].value_or(std::string{});
}

using Names = std::span<const std::string>;

/// The first block of an array of tables whose key has this text and whose name is not left out.
const toml::table* block_with(const toml::table& rig, std::string_view array, std::string_view key,
                              std::string_view text, Names left_out = {}) {
  const auto* blocks = rig[array].as_array();
  if (blocks == nullptr) return nullptr;
  for (const auto& item : *blocks)
    if (const auto* block = item.as_table();
        block != nullptr && text_at(*block, key) == text &&
        std::ranges::find(left_out, text_at(*block, "name")) == left_out.end())
      return block;
  return nullptr;
}

toml::table new_block(const toml::table& rig, const EstimatorFacts& facts, Names left_out) {
  std::string name(facts.name);
  std::ranges::replace(name, '-', '_');  // it becomes part of ROS 2 topics
  toml::table block{{"name", name}, {"kind", std::string(facts.name)}};
  const auto name_device = [&](std::string_view key, measurement::Kind kind) {
    if (const auto* device = block_with(rig, "device", "kind", to_string(kind), left_out))
      block.insert_or_assign(key, text_at(*device, "name"));
  };
  if (facts.has_imu) name_device("imu", measurement::Kind::imu);
  for (const auto& device : facts.devices) name_device(device.key, device.kind);
  return block;
}

toml::table block_of(const toml::table& rig, std::string_view head, Names left_out) {
  if (const auto* named = block_with(rig, "estimator", "name", head)) return *named;
  if (const auto* of_kind = block_with(rig, "estimator", "kind", head)) return *of_kind;
  if (const auto* facts = facts_named(head)) return new_block(rig, *facts, left_out);
  std::vector<std::string_view> kinds;
  kinds.reserve(std::size(estimator_facts));
  for (const auto& facts : estimator_facts) kinds.push_back(facts.name);
  throw std::invalid_argument(
      fmt::format("{}: the rig has no estimator of this name, and it is no kind, allowed: {}", head,
                  fmt::join(kinds, ", ")));
}

/// A value as TOML has it. What is none is a text without its quotes.
void insert_value(toml::table& table, std::string_view key, std::string_view value) {
  try {
    const auto parsed = toml::parse(fmt::format("value = {}", value));
    table.insert_or_assign(key, *parsed.get("value"));
  } catch (const toml::parse_error&) {
    table.insert_or_assign(key, std::string(value));
  }
}

void set_key(toml::table& block, std::string_view assignment) {
  const auto equals = assignment.find('=');
  if (equals == assignment.npos || equals == 0)
    throw std::invalid_argument(fmt::format("\"{}\": an option is KEY=VALUE", assignment));
  const auto value = assignment.substr(equals + 1);
  auto path = split_values(assignment.substr(0, equals), '.');
  const auto key = path.back();
  path.pop_back();
  toml::table* table = &block;
  for (const auto part : path) {
    auto* inner = table->get(part);
    if (inner == nullptr || !inner->is_table())
      inner = &table->insert_or_assign(part, toml::table{}).first->second;
    table = inner->as_table();
  }
  if (value.empty())
    table->erase(key);
  else
    insert_value(*table, key, value);
}

}  // namespace

std::string with_estimator(std::string_view text, std::string_view choice, Names left_out) {
  toml::table rig;
  try {
    rig = toml::parse(text);
  } catch (const toml::parse_error& error) {
    throw std::invalid_argument(fmt::format("the rig file is no TOML: {}", error.description()));
  }
  const auto parts = split_values(choice, ':');
  toml::table block = block_of(rig, parts.front(), left_out);
  for (std::size_t i = 1; i < parts.size(); ++i) set_key(block, parts[i]);
  rig.erase("expect");
  rig.insert_or_assign("estimator", toml::array{std::move(block)});
  std::ostringstream out;
  out << rig << '\n';
  return std::move(out).str();
}

}  // namespace drydock::rig_config
