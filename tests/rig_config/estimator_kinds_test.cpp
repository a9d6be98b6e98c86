#include "rig_config/estimator/kinds.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "rig_config/load.hpp"

/// The rows of the kinds of estimators and the schema say the same.
namespace drydock::rig_config {
namespace estimator_kinds_test {

using Json = nlohmann::json;

Json estimator_schema() { return Json::parse(schema_text())["definitions"]["estimator"]; }

std::vector<std::string> names_of_kinds() {
  std::vector<std::string> names;
  for (const EstimatorFacts& facts : estimator_facts) names.emplace_back(facts.name);
  return names;
}

/// Kinds for which a `then` or `else` of the schema forbids the key.
void find_forbidden(const Json& rule, const std::string& key, std::set<std::string> kinds,
                    std::set<std::string>& forbidden) {
  if (rule.contains("properties") && rule["properties"].contains(key) &&
      rule["properties"][key].contains("not"))
    forbidden.insert(kinds.begin(), kinds.end());
  if (rule.contains("allOf"))
    for (const Json& each : rule["allOf"]) find_forbidden(each, key, kinds, forbidden);
  if (!rule.contains("if")) return;
  const Json& properties = rule["if"]["properties"];
  if (!properties.contains("kind")) return;  // a rule between two keys of one kind
  const Json& kind = properties["kind"];
  const Json named = kind.contains("const") ? Json::array({kind["const"]}) : kind["enum"];
  std::set<std::string> then, otherwise;
  for (const auto& name : kinds)
    (std::ranges::find(named, Json(name)) != named.end() ? then : otherwise).insert(name);
  if (rule.contains("then")) find_forbidden(rule["then"], key, then, forbidden);
  if (rule.contains("else")) find_forbidden(rule["else"], key, otherwise, forbidden);
}

TEST(EstimatorKinds, TheSchemaListsEveryKindInTheOrderOfTheRows) {
  const Json schema = estimator_schema();
  EXPECT_EQ(schema["properties"]["kind"]["enum"], Json(names_of_kinds()));
  EXPECT_EQ(schema["if"]["properties"]["kind"]["enum"], Json(names_of_kinds()));
}

TEST(EstimatorKinds, ADeviceKeyIsAllowedForTheKindsWhoseRowsHaveIt) {
  const auto names = names_of_kinds();
  std::set<std::string_view> keys;
  for (const EstimatorFacts& facts : estimator_facts)
    for (const DeviceKey& device : facts.devices) keys.insert(device.key);
  for (const auto key : keys) {
    std::set<std::string> forbidden, without;
    find_forbidden(estimator_schema(), std::string(key), {names.begin(), names.end()}, forbidden);
    for (const EstimatorFacts& facts : estimator_facts)
      if (std::ranges::find(facts.devices, key, &DeviceKey::key) == facts.devices.end())
        without.emplace(facts.name);
    EXPECT_EQ(forbidden, without) << key;
  }
}

TEST(EstimatorKinds, ARowIsFoundByItsNameAndByItsKeys) {
  for (const EstimatorFacts& facts : estimator_facts) EXPECT_EQ(facts_named(facts.name), &facts);
  EXPECT_EQ(facts_named("levelling"), nullptr);
  EXPECT_EQ(facts_of(VelocityConfig{}).name, "velocity");
}

}  // namespace estimator_kinds_test
}  // namespace drydock::rig_config
