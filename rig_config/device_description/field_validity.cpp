#include "rig_config/device_description/field_validity.hpp"

namespace drydock::rig_config {

using wire::described::Field;
using wire::described::Type;
using wire::described::Validity;

void read_validity(const Node& table, const FieldContext& context, Field& field,
                   Problems& problems) {
  const auto add = [&](const Node& at, std::string what) {
    problems.push_back({context.file, at.at.line, at.at.column, context.path, std::move(what)});
  };
  const Node* good = table.find("good");
  const Node* above = table.find("above");
  const Node* bad = table.find("bad");
  if (!field.validity) {
    for (const Node* key : {good, above, bad})
      if (key) add(*key, "only for field = \"valid\"");
    return;
  }
  if (!good && !above)
    add(table, "field \"valid\" needs 'good' (the values that say so) or 'above'");
  Validity& rule = *field.validity;
  if (above) rule.above = above->number;
  const bool texts = field.type == Type::text;
  for (const Node& one : good ? good->items : std::vector<Node>{}) {
    if (texts != (one.kind == Node::Kind::text))
      add(one, texts ? "a field of type text has texts here"
                     : "a number is expected here, or type = \"text\" for the field");
    if (texts)
      rule.good_texts.push_back(one.text);
    else
      rule.good_numbers.push_back(one.number);
  }
  if (texts && rule.good_texts.empty()) add(table, "a text cannot be above a number: use 'good'");
  if (bad) rule.bad_text = bad->text, rule.bad_number = bad->number;
  if (!rule.good_numbers.empty())
    field.idle = rule.good_numbers.front();
  else if (rule.above)
    field.idle = *rule.above + 1;
}

}  // namespace drydock::rig_config
