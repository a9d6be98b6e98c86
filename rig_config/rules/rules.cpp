#include "rig_config/rules/rules.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace drydock::rig_config {

namespace {

using Json = nlohmann::json;
using Schemas = std::vector<const Json*>;

/// The object or array at `key`, or an empty object if the key is absent.
const Json& part(const Json& schema, const char* key) {
  static const Json nothing = Json::object();
  const auto found = schema.find(key);
  return found == schema.end() ? nothing : *found;
}

/// Evaluates the conditions that the rig schema uses: required keys and their texts, in tables too.
bool holds(const Json& condition, const Node& node) {
  for (const Json& key : part(condition, "required"))
    if (!node.find(key.get<std::string>())) return false;
  for (const auto& [key, rule] : part(condition, "properties").items()) {
    const Node* table = node.find(key);
    if (table && table->kind == Node::Kind::table) {
      if (!holds(rule, *table)) return false;
      continue;
    }
    const Node* value = node.find_text(key);
    if (!value) return false;
    if (rule.contains("const") && rule["const"] != value->text) return false;
    if (rule.contains("enum") &&
        std::ranges::find(rule["enum"], Json(value->text)) == rule["enum"].end())
      return false;
  }
  return true;
}

/// Adds `schema` and the schemas that it includes for `node` by `$ref`, `allOf` and `if`.
void flatten(const Json& root, const Json& schema, const Node& node, Schemas& out) {
  if (const auto ref = schema.find("$ref"); ref != schema.end()) {
    const std::string pointer = ref->get<std::string>().substr(1);  // after '#'
    return flatten(root, root.at(Json::json_pointer(pointer)), node, out);
  }
  out.push_back(&schema);
  if (const auto all = schema.find("allOf"); all != schema.end())
    for (const Json& each : *all) flatten(root, each, node, out);
  if (const auto condition = schema.find("if"); condition != schema.end()) {
    const auto branch = schema.find(holds(*condition, node) ? "then" : "else");
    if (branch != schema.end()) flatten(root, *branch, node, out);
  }
}

const Node* child(const Node& node, const std::string& step) {
  if (node.kind == Node::Kind::table) return node.find(step);
  if (node.kind != Node::Kind::array) return nullptr;
  const std::size_t index = std::stoul(step);
  return index < node.items.size() ? &node.items[index] : nullptr;
}

/// The schemas of one member or item of a value.
Schemas descend(const Json& root, const Schemas& schemas, const std::string& step, const Node& to,
                bool into_array) {
  Schemas below;
  for (const Json* schema : schemas) {
    const auto group = schema->find(into_array ? "items" : "properties");
    if (group == schema->end()) continue;
    if (into_array) {
      flatten(root, *group, to, below);
    } else if (const auto rule = group->find(step); rule != group->end()) {
      flatten(root, *rule, to, below);
    }
  }
  return below;
}

void narrow(std::optional<Bound>& bound, const Json& schema, const char* inclusive,
            const char* exclusive, bool is_lower) {
  for (const char* word : {inclusive, exclusive}) {
    const auto limit = schema.find(word);
    if (limit == schema.end()) continue;
    const double value = limit->get<double>();
    if (!bound || (is_lower ? value > bound->value : value < bound->value))
      bound = Bound{value, word == exclusive};
  }
}

void merge_keys(Rules& rules, const Json& schema) {
  for (const Json& key : part(schema, "required")) rules.required.push_back(key);
  if (!schema.contains("additionalProperties")) return;
  rules.closed = true;
  for (const auto& [key, rule] : schema.at("properties").items()) rules.known.push_back(key);
}

void merge(Rules& rules, const Json& schema) {
  if (const auto type = schema.find("type"); type != schema.end() && rules.types.empty())
    rules.types = type->is_array() ? type->get<std::vector<std::string>>()
                                   : std::vector{type->get<std::string>()};
  rules.date_time |= schema.value("format", "") == "date-time";
  if (const auto choices = schema.find("enum"); choices != schema.end())
    if (rules.choices.empty() || choices->size() < rules.choices.size())
      rules.choices = choices->get<std::vector<std::string>>();
  narrow(rules.lower, schema, "minimum", "exclusiveMinimum", true);
  narrow(rules.upper, schema, "maximum", "exclusiveMaximum", false);
  if (const auto pattern = schema.find("pattern"); pattern != schema.end())
    rules.patterns.push_back({*pattern, schema.value("description", "")});
  rules.min_length = std::max(rules.min_length, schema.value("minLength", std::size_t{0}));
  rules.min_items = std::max(rules.min_items, schema.value("minItems", std::size_t{0}));
  rules.max_items = std::min(rules.max_items, schema.value("maxItems", rules.max_items));
  rules.min_members = std::max(rules.min_members, schema.value("minProperties", std::size_t{0}));
  if (schema.contains("not")) rules.forbidden = schema.value("description", "");
  merge_keys(rules, schema);
}

void withdraw_forbidden(Rules& rules, const Schemas& schemas) {
  rules.allowed = rules.known;
  for (const Json* schema : schemas)
    for (const auto& [key, rule] : part(*schema, "properties").items())
      if (rule.contains("not")) std::erase(rules.allowed, key);
}

}  // namespace

std::optional<Ruled> rules_at(const Json& schema, const Node& root,
                              const std::vector<std::string>& place) {
  Schemas schemas;
  flatten(schema, schema, root, schemas);
  const Node* node = &root;
  for (const std::string& step : place) {
    const Node* next = child(*node, step);
    if (!next) return std::nullopt;
    schemas = descend(schema, schemas, step, *next, node->kind == Node::Kind::array);
    node = next;
  }
  Ruled ruled{node, {}};
  for (const Json* rule : schemas) merge(ruled.rules, *rule);
  withdraw_forbidden(ruled.rules, schemas);
  return ruled;
}

}  // namespace drydock::rig_config
