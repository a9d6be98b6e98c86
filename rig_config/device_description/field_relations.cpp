#include "rig_config/device_description/field_relations.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rig_config/device_description/units.hpp"

namespace drydock::rig_config {
namespace {

namespace described = wire::described;
using described::Field;

/// A unit that a part may have.
std::string_view units_like(described::Dimension dimension) {
  for (const WireUnit& unit : wire_units)
    if (unit.dimension == dimension) return unit.name;
  return "1";
}

struct Relations {
  const std::string& file;
  const std::string path;  ///< of the field at `i`
  const Node& table;
  std::vector<Field>& fields;
  std::size_t i;
  Problems& problems;

  void add(const Node& at, const std::string& where, std::string what) {
    problems.push_back({file, at.at.line, at.at.column, where, std::move(what)});
  }

  void find_divisor() {
    const Node* per = table.find("per");
    if (!per) return;
    const auto found = std::ranges::find(fields, per->text, &Field::key);
    const bool is_time = found != fields.end() && found->target &&
                         described::row_of(*found->target).dimension == described::dimension::time;
    if (!is_time || !fields[i].target)
      return add(*per, path + "/per",
                 "names a field of this message that is a time, for a 'field'");
    fields[i].divisor = static_cast<std::uint8_t>(found - fields.begin());
  }

  /// Its whole is in the same dimension: the unit may be another one.
  void find_whole() {
    const Node* to = table.find("adds_to");
    if (!to) return;
    const auto found = std::ranges::find(fields, to->text, &Field::key);
    const bool is_value = found != fields.end() && found->target && fields[i].key != to->text;
    if (!is_value || fields[i].target || found->divisor || found->offset != 0)
      return add(*to, path + "/adds_to",
                 "names a 'field' of this message, without 'per' and 'offset'; the part itself has "
                 "a 'name'");
    const auto& whole = described::row_of(*found->target);
    const Node* named = table.find("unit");
    const WireUnit* unit = named ? find_unit(named->text) : nullptr;
    if (!unit || !(unit->dimension == whole.dimension) || described::notation_named(unit->name))
      return add(named ? *named : table, path + "/unit",
                 fmt::format("a part of {} needs a unit of it, such as \"{}\"", whole.name,
                             units_like(whole.dimension)));
    if (fields[i].factor <= 0 || fields[i].offset != 0 || found->factor <= 0)
      return add(table, path, "a part and its whole have positive scales, and no 'offset'");
    found->has_parts = true;
    fields[i].part_of = static_cast<std::uint8_t>(found - fields.begin());
    fields[i].part_factor = unit->factor;
  }

  void find_signed() {
    const Node* of = table.find("sign_of");
    if (!of) return;
    const auto found = std::ranges::find(fields, of->text, &Field::key);
    if (found == fields.end())
      return add(*of, path + "/sign_of", "names a field of this message that has the sign");
    found->signed_apart = true;
    fields[i].sign_of = static_cast<std::uint8_t>(found - fields.begin());
  }

  void check_key() {
    const std::string& key = fields[i].key;
    const auto first = std::ranges::find(fields, key, &Field::key) - fields.begin();
    if (key.empty() || first == static_cast<std::ptrdiff_t>(i)) return;
    add(table, path,
        fmt::format("two fields of this message are called \"{}\"; give one a 'name'", key));
  }

  void check_blanks() {
    const bool between = fields[i].end == ' ' || (i > 0 && fields[i - 1].end == ' ');
    const bool constant = fields[i].type == described::Type::constant;
    if (between && constant && fields[i].text.empty())
      add(table, path, "a run of blanks is one separator, so no field between blanks is empty");
  }

  void check_optional() {
    if (i > 0 && fields[i - 1].optional && !fields[i].optional)
      add(table, path, "fields behind an optional one must be optional too");
  }
};

}  // namespace

void relate_fields(std::span<const Node> tables, bool in_order, std::vector<Field>& fields,
                   const std::string& file, const std::string& path, Problems& problems) {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    Relations one{file, fmt::format("{}/fields/{}", path, i), tables[i], fields, i, problems};
    one.find_divisor();
    one.find_whole();
    one.find_signed();
    one.check_key();
    if (!in_order) continue;
    one.check_optional();
    one.check_blanks();
  }
}

std::vector<std::uint8_t> mapped(const std::vector<Field>& fields) {
  std::vector<std::uint8_t> order;
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (fields[i].target) order.push_back(static_cast<std::uint8_t>(i));
  std::ranges::stable_sort(order, {}, [&](std::uint8_t i) { return fields[i].rank; });
  return order;
}

}  // namespace drydock::rig_config
