#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "drivers/wire/protocols.hpp"
#include "rig_config/load.hpp"
#include "rig_config/rules/protocol_lists.hpp"

namespace drydock::rig_config {
namespace {

using Json = nlohmann::json;

std::string read(const std::string& relative) {
  std::ifstream in(DRYDOCK_SOURCE_DIR "/" + relative, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Calls `visit(schema)` for a schema and every schema inside it.
template <class Visit>
void for_each_schema(const Json& schema, Visit&& visit) {
  visit(schema);
  for (const char* group : {"properties", "definitions"})
    if (schema.contains(group))
      for (const Json& inner : schema[group]) for_each_schema(inner, visit);
  for (const char* single : {"items", "if", "then", "else", "not"})
    if (schema.contains(single)) for_each_schema(schema[single], visit);
  if (schema.contains("allOf"))
    for (const Json& inner : schema["allOf"]) for_each_schema(inner, visit);
}

std::set<std::string> keys_of_schemas() {
  std::set<std::string> keys;
  for (const auto text : {schema_text(), vehicle_schema_text()})
    for_each_schema(Json::parse(text), [&](const Json& schema) {
      if (schema.contains("properties"))
        for (const auto& entry : schema["properties"].items()) keys.insert(entry.key());
    });
  return keys;
}

TEST(Schema, TheProgramHoldsTheFilesThatEditorsRead) {
  EXPECT_EQ(schema_text(), read("rig_config/schema/rig.schema.json"));
  EXPECT_EQ(vehicle_schema_text(), read("rig_config/schema/vehicle.schema.json"));
  EXPECT_EQ(device_schema_text(), read("rig_config/schema/device.schema.json"));
}

TEST(Schema, EveryWordIsOneOfDraft07AndOfItsType) {
  const std::map<std::string, std::vector<Json::value_t>> words{
      {"$schema", {Json::value_t::string}},
      {"$comment", {Json::value_t::string}},
      {"$ref", {Json::value_t::string}},
      {"title", {Json::value_t::string}},
      {"description", {Json::value_t::string}},
      {"format", {Json::value_t::string}},
      {"pattern", {Json::value_t::string}},
      {"type", {Json::value_t::string, Json::value_t::array}},
      {"enum", {Json::value_t::array}},
      {"required", {Json::value_t::array}},
      {"allOf", {Json::value_t::array}},
      {"definitions", {Json::value_t::object}},
      {"properties", {Json::value_t::object}},
      {"items", {Json::value_t::object}},
      {"if", {Json::value_t::object}},
      {"then", {Json::value_t::object}},
      {"else", {Json::value_t::object}},
      {"not", {Json::value_t::object}},
      {"additionalProperties", {Json::value_t::boolean}},
      {"const", {Json::value_t::string}},
      {"protocols", {Json::value_t::string}}};
  const std::set<std::string> numbers{"minimum",  "maximum",   "exclusiveMinimum", "minItems",
                                      "maxItems", "minLength", "minProperties"};
  for (const auto text : {schema_text(), vehicle_schema_text(), device_schema_text()}) {
    const Json root = Json::parse(text);
    EXPECT_EQ(root["$schema"], "http://json-schema.org/draft-07/schema#");
    for_each_schema(root, [&](const Json& schema) {
      for (const auto& [word, value] : schema.items()) {
        if (numbers.contains(word)) {
          EXPECT_TRUE(value.is_number()) << word;
        } else {
          ASSERT_TRUE(words.contains(word)) << word;
          EXPECT_THAT(words.at(word), testing::Contains(value.type())) << word;
        }
      }
      if (schema.contains("$ref")) {
        EXPECT_TRUE(root.contains(Json::json_pointer(schema["$ref"].get<std::string>().substr(1))));
      }
    });
  }
}

/// The lists of protocols by their name in the schema, as the program fills them.
std::map<std::string, std::vector<std::string>> lists_of_protocols() {
  std::map<std::string, std::vector<std::string>> lists;
  const Json before = Json::parse(schema_text()).flatten();
  const Json after = with_protocol_lists(Json::parse(schema_text()));
  for (const auto& [pointer, word] : before.items())
    if (pointer.ends_with("/protocols"))
      lists[word] = after.at(Json::json_pointer(pointer.substr(0, pointer.rfind('/'))))
                        .at("enum")
                        .get<std::vector<std::string>>();
  return lists;
}

TEST(Schema, TheListsOfProtocolsAreFilledFromTheTable) {
  using testing::Contains, testing::IsSupersetOf, testing::Not;
  auto lists = lists_of_protocols();
  EXPECT_EQ(lists.size(), measurement::kinds.size() + 4);
  EXPECT_THAT(lists["dvl"], IsSupersetOf({"pd0", "pd4", "pd5", "pd6", "water-linked",
                                          "water-linked-json", "nortek"}));
  EXPECT_THAT(lists["dvl"], Not(Contains("ubx")));
  EXPECT_THAT(lists["gnss"], IsSupersetOf({"ubx", "nmea0183", "ubx+nmea0183"}));
  EXPECT_THAT(lists["depth"], IsSupersetOf({"nmea2000", "cia404-pressure"}));
  EXPECT_THAT(lists["canopen"], IsSupersetOf({"cia402", "cia404-imu", "cia404-pressure",
                                              "epson-g550", "epson-g552"}));
  EXPECT_THAT(lists["canopen"], Not(Contains("nmea2000")));
  EXPECT_EQ(lists["bytes"].size() + lists["frames"].size(), lists["all"].size());
  EXPECT_THAT(lists["all"], Not(Contains("slcan"))) << "only protocols with a kind";
}

TEST(Schema, AnEditorSeesTheSameCanopenProtocolsAsTheProgram) {
  const std::regex pattern("^(cia40[24]|epson)");
  EXPECT_NE(schema_text().find("{\"pattern\": \"^(cia40[24]|epson)\", \"protocols\": \"canopen\"}"),
            std::string_view::npos);
  for (const wire::Protocol& protocol : wire::protocols())
    EXPECT_EQ(std::regex_search(std::string(protocol.name), pattern),
              protocol.network == wire::Network::canopen)
        << protocol.name;
}

TEST(Schema, AnEmulatedSensorTakesTheSameErrorKeysInlineAndFromAFile) {
  const Json definitions = Json::parse(schema_text())["definitions"];
  for (const std::string kind : {"dvl", "emlog", "gnss", "imu", "depth", "actuator", "attitude"}) {
    Json inlined = definitions[kind + "_emulate"]["properties"],
         in_file = definitions[kind + "_errors"]["properties"];
    for (const char* only_inline : {"errors", "sky", "head", "reference", "variation_deg", "model"})
      inlined.erase(only_inline);
    for (const char* elsewhere_in_a_rig : {"rate_hz", "power_noise"})
      in_file.erase(elsewhere_in_a_rig);
    EXPECT_EQ(inlined, in_file) << kind;
  }
}

TEST(Schema, EveryKeyIsInTheManual) {
  const std::string manual = read("docs/use/configuration.md");
  for (const std::string& key : keys_of_schemas())
    EXPECT_NE(manual.find("`" + key + "`"), std::string::npos) << key;
}

TEST(Schema, EveryShippedFileNamesTheSchemaForEditors) {
  for (const char* file :
       {"rigs/demo.toml", "rigs/replayed-gps.toml", "rigs/bench-serial.toml",
        "rigs/sounding-rocket.toml", "rigs/shelf.toml", "rigs/velocity-paper.toml",
        "missions/s-path.toml", "missions/shelf.toml", "missions/sounding-rocket.toml",
        "missions/velocity-paper.toml", "missions/mixing-paper.toml", "sensors/leveling-paper.toml",
        "sensors/velocity-filter-paper.toml", "sensors/gps-roll-paper.toml",
        "sensors/mixing-paper.toml", "sensors/xsens-mti-630.toml", "sensors/water-linked-a50.toml"})
    EXPECT_TRUE(
        read(std::string("rig_config/") + file).starts_with("#:schema ../schema/rig.schema.json\n"))
        << file;
  for (const char* file : {"vehicles/nps-auv-ii.toml", "vehicles/nps-auv-ii-asymmetric.toml"})
    EXPECT_TRUE(read(std::string("rig_config/") + file)
                    .starts_with("#:schema ../schema/vehicle.schema.json\n"))
        << file;
}

}  // namespace
}  // namespace drydock::rig_config
