#include "rig_config/rules/schema_check.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "rig_config/rules/explain.hpp"
#include "rig_config/rules/protocol_lists.hpp"

namespace drydock::rig_config {

namespace {

using Json = nlohmann::json;
using Kind = Node::Kind;

/// TOML has date-times and strings, JSON has only strings. If the file has one instead of the
/// other, the value becomes null, and the schema refuses null.
Json to_json(const Node& node, const std::string& path = "") {
  const bool date_wanted = path == "/rig/start" || path == "/device//emulate/sky/at";
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

struct Complaint {
  std::string path, words;
};

/// valijson 1.0 expects a string for every value with a "format" and aborts on a list or a table.
/// This schema uses "format" only for date-times, and the reader has checked these before.
Json without_formats(Json schema) {
  if (schema.is_object() && schema.contains("format") && schema["format"].is_string())
    schema.erase("format");
  for (auto& part : schema)
    if (part.is_structured()) part = without_formats(std::move(part));
  return schema;
}

/// The result of valijson: nothing, or the deepest error. It repeats each error for the parents.
std::optional<Complaint> verdict(const Json& schema_json, const Json& document) {
  valijson::Schema schema;
  valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
  const Json rules = without_formats(schema_json);
  parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(rules), schema);
  valijson::Validator validator;
  valijson::ValidationResults results;
  const valijson::adapters::NlohmannJsonAdapter target(document);
  if (validator.validate(schema, target, &results)) return std::nullopt;
  const auto depth = [](const auto& error) { return error.context.size(); };
  const auto deepest = std::ranges::max_element(results, {}, depth);
  if (deepest == results.end()) return Complaint{"/", "does not fit the schema"};
  Complaint complaint{"", deepest->description};
  for (const std::string& step : deepest->context)  // "<root>", then "[key]" or "[index]"
    if (step != "<root>") complaint.path += "/" + step.substr(1, step.size() - 2);
  return complaint;
}

/// Describes the broken rules of every place, parents before their members. valijson alone stops at
/// the first failing branch of an allOf and does not say what is allowed.
class Walk {
 public:
  Walk(const Json& schema, const Node& root, const std::string& file)
      : schema_(schema), root_(root), file_(file) {}

  Problems run() {
    visit(root_);
    return std::move(problems_);
  }

 private:
  void visit(const Node& node) {
    constexpr std::size_t enough = 200;
    if (problems_.size() >= enough) return;
    if (const auto ruled = rules_at(schema_, root_, place_)) {
      Problems here = explain(*ruled, file_, fmt::format("/{}", fmt::join(place_, "/")));
      std::ranges::move(here, std::back_inserter(problems_));
    }
    for (const auto& [key, member] : node.members) descend(key, member);
    for (std::size_t i = 0; i < node.items.size(); ++i) descend(std::to_string(i), node.items[i]);
  }
  void descend(const std::string& step, const Node& node) {
    place_.push_back(step);
    visit(node);
    place_.pop_back();
  }

  const Json& schema_;
  const Node& root_;
  const std::string& file_;
  std::vector<std::string> place_;
  Problems problems_;
};

}  // namespace

Problems check_schema(const Node& root, const std::string& file, std::string_view schema_text,
                      std::span<const wire::Protocol> described) {
  const Json schema = with_protocol_lists(Json::parse(schema_text), described);
  const auto complaint = verdict(schema, to_json(root));
  if (!complaint) return {};
  Problems problems = Walk(schema, root, file).run();
  // A document can break a rule that explain() does not know. It must be refused all the same.
  if (problems.empty()) problems.push_back({file, 1, 1, complaint->path, complaint->words});
  return problems;
}

}  // namespace drydock::rig_config
