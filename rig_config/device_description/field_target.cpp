#include "rig_config/device_description/field_target.hpp"

#include <fmt/format.h>

#include "rig_config/device_description/units.hpp"
#include "rig_config/rules/explain.hpp"
#include "rig_config/toml/read_keys.hpp"

namespace drydock::rig_config {
namespace {

namespace described = wire::described;
using described::Dimension;
using described::Field;
using described::TargetRow;
using described::Type;

const TargetRow* find_target(std::string_view name, measurement::Kind kind) {
  for (const TargetRow& row : described::target_rows)
    if (row.name == name && (row.kinds & described::bit_of(kind)) != 0) return &row;
  return nullptr;
}

std::vector<std::string> target_names(measurement::Kind kind) {
  std::vector<std::string> names{std::string(valid_word)};
  for (const TargetRow& row : described::target_rows)
    if ((row.kinds & described::bit_of(kind)) != 0) names.emplace_back(row.name);
  return names;
}

Dimension on_the_wire(const Node& table, const TargetRow& row) {
  Dimension dimension = row.dimension;
  if (table.find("per")) dimension.time = static_cast<std::int8_t>(dimension.time + 1);
  return dimension;
}

void add(Problems& problems, const FieldContext& context, const Node& at, std::string what) {
  problems.push_back({context.file, at.at.line, at.at.column, context.path, std::move(what)});
}

void read_unit(const Node& table, const FieldContext& context, const TargetRow& row,
               const std::string& unit_of_file, Field& field, Problems& problems) {
  const Dimension wanted = on_the_wire(table, row);
  std::vector<std::string> allowed;
  for (const WireUnit& unit : wire_units)
    if (unit.dimension == wanted) allowed.emplace_back(unit.name);
  if (allowed.empty())
    return add(problems, context, *table.find("per"),
               fmt::format("{} is nothing that a time divides", row.name));
  const Node* named = table.find("unit");
  const std::string word = named ? named->text : wanted == Dimension{} ? "1" : unit_of_file;
  const WireUnit* unit = find_unit(word);
  if (!unit || !(unit->dimension == wanted))
    return add(problems, context, named ? *named : table,
               fmt::format("{} of {}, allowed: {}",
                           word.empty() ? "no unit" : fmt::format("\"{}\" is no unit", word),
                           row.name, listed(allowed)));
  field.notation = described::notation_named(unit->name).value_or(described::Notation{});
  const bool of_text =
      context.form == described::Form::sentences || context.form == described::Form::lines;
  if (!field.notation.is_plain() && !of_text)
    add(problems, context, named ? *named : table,
        fmt::format("only a number of a text is written as {}", unit->name));
  const double scale = read_if(table, "scale").value_or(1);
  field.factor = scale * unit->factor;
  field.offset = read_if(table, "offset").value_or(0) * unit->factor + unit->offset;
}

}  // namespace

void read_target(const Node& table, const FieldContext& context, const std::string& unit_of_file,
                 Field& field, Problems& problems) {
  const Node& word = *table.find("field");
  if (field.key.empty()) field.key = word.text;
  if (word.text == valid_word) {
    field.validity.emplace();
    return;
  }
  if (!context.kind)
    return add(problems, context, word,
               "a field is measured by a kind of sensor: [sensor] has no key 'kind'");
  const TargetRow* row = find_target(word.text, *context.kind);
  if (!row) {
    const auto names = target_names(*context.kind);
    return add(
        problems, context, word,
        fmt::format("\"{}\" is nothing that a {} measures{}, allowed: {}", word.text,
                    to_string(*context.kind), did_you_mean(word.text, names), listed(names)));
  }
  if (field.type == Type::text)
    add(problems, context, word, "a text is no measurement; allowed: number, hex");
  field.target = row->target;
  read_unit(table, context, *row, unit_of_file, field, problems);
}

void scale_plainly(const Node& table, const FieldContext& context, Field& field,
                   Problems& problems) {
  const Node* named = table.find("unit");
  if (named && !table.find("field") && !find_unit(named->text)) {
    std::vector<std::string> names;
    names.reserve(std::size(wire_units));
    for (const WireUnit& unit : wire_units) names.emplace_back(unit.name);
    add(problems, context, *named,
        fmt::format("\"{}\" is no unit{}, allowed: {}", named->text,
                    did_you_mean(named->text, names), listed(names)));
  }
  read(table, "scale", field.factor);
  read(table, "offset", field.offset);
}

}  // namespace drydock::rig_config
