#include "rig_config/toml/rewrite.hpp"

#include <toml++/toml.h>

#include <sstream>
#include <vector>

namespace drydock::rig_config {

namespace {

void rewrite_table(toml::table& table, const Rewriting& rewriting);

void rewrite_array(toml::array& array, const Rewriting& rewriting) {
  for (auto& item : array) {
    if (auto* inner = item.as_table()) rewrite_table(*inner, rewriting);
    if (auto* inner = item.as_array()) rewrite_array(*inner, rewriting);
  }
}

/// An unchanged integer stays an integer, because a key such as an address refuses a number with a
/// decimal point.
void rewrite_numbers(toml::table& table, const Rewriting& rewriting) {
  std::vector<std::pair<std::string, double>> changed;
  for (auto&& [key, value] : table) {
    const std::string name{key.str()};
    const auto old = value.value_exact<double>();
    const auto whole = value.value_exact<std::int64_t>();
    if (!old && !whole) continue;
    const double before = old ? *old : static_cast<double>(*whole);
    const double after = rewriting.number(name, before);
    if (after != before) changed.emplace_back(name, after);
  }
  for (const auto& [name, number] : changed) table.insert_or_assign(name, number);
}

void rewrite_table(toml::table& table, const Rewriting& rewriting) {
  rewrite_numbers(table, rewriting);
  std::vector<std::string> dates;
  for (auto&& [key, value] : table) {
    if (auto* inner = value.as_table()) rewrite_table(*inner, rewriting);
    if (auto* inner = value.as_array()) rewrite_array(*inner, rewriting);
    if (value.is_date_time() || value.is_date()) dates.emplace_back(key.str());
  }
  if (!rewriting.without_dates) return;
  for (const auto& name : dates) table.erase(name);
}

}  // namespace

std::optional<std::string> rewrite(std::string_view document, const Rewriting& rewriting) {
  try {
    toml::table table = toml::parse(document);
    rewrite_table(table, rewriting);
    std::ostringstream text;
    text << table << '\n';
    return std::move(text).str();
  } catch (const toml::parse_error&) {
    return {};
  }
}

}  // namespace drydock::rig_config
