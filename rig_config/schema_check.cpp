#include "rig_config/schema_check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <set>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "rig_config/explain.hpp"

namespace drydock::rig_config {

namespace {

using Json = nlohmann::json;
using Kind = Node::Kind;
using Place = std::vector<std::string>;

/// JSON knows no date-time, TOML tells it from a string: where one stands for the other the value
/// becomes null, which the schema refuses.
Json to_json(const Node& node, const std::string& path = "") {
  const bool date_wanted = path == "/rig/start";
  switch (node.kind) {
    case Kind::boolean: return node.boolean;
    case Kind::integer: return node.integer;
    case Kind::number: return node.number;
    case Kind::text: return date_wanted ? Json() : Json(node.text);
    case Kind::date_time: return date_wanted ? Json(node.text) : Json();
    case Kind::array: {
      Json array = Json::array();
      for (const Node& item : node.items) array.push_back(to_json(item, path + "/"));
      return array;
    }
    case Kind::table: break;
  }
  Json object = Json::object();
  for (const auto& [key, value] : node.members) object[key] = to_json(value, path + "/" + key);
  return object;
}

/// Every place that valijson complains of, with its own words for it. It names parents too.
std::vector<std::pair<Place, std::string>> complaints(const Json& schema_json,
                                                      const Json& document) {
  valijson::Schema schema;
  valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
  parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(schema_json), schema);
  valijson::Validator validator;
  valijson::ValidationResults results;
  validator.validate(schema, valijson::adapters::NlohmannJsonAdapter(document), &results);
  std::vector<std::pair<Place, std::string>> found;
  for (const auto& error : results) {
    Place place;
    for (const std::string& step : error.context)  // "<root>", then "[key]" or "[index]"
      if (step != "<root>") place.push_back(step.substr(1, step.size() - 2));
    found.emplace_back(std::move(place), error.description);
  }
  return found;
}

}  // namespace

Problems check_schema(const Node& root, const std::string& file) {
  const Json schema = Json::parse(schema_text());
  const auto found = complaints(schema, to_json(root));
  Problems problems;
  std::set<Place> seen;
  for (const auto& [place, words] : found) {
    if (!seen.insert(place).second) continue;
    if (const auto ruled = rules_at(schema, root, place)) {
      Problems here = explain(*ruled, file, fmt::format("/{}", fmt::join(place, "/")));
      std::ranges::move(here, std::back_inserter(problems));
    }
  }
  if (problems.empty() && !found.empty()) {
    const auto& [place, words] = found.front();  // a rule that explain() has no words for
    problems.push_back({file, 1, 1, fmt::format("/{}", fmt::join(place, "/")), words});
  }
  return problems;
}

}  // namespace drydock::rig_config
