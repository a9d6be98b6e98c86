#include "drivers/live/foxglove/foxglove.hpp"

#include <boost/endian/conversion.hpp>
#include <nlohmann/json.hpp>
#include <optional>

namespace drydock::live {

namespace {

using nlohmann::json;

/// Empty unless the value is an integer that fits.
std::optional<std::uint32_t> number_of(const json& value) {
  if (!value.is_number_unsigned() || value > UINT32_MAX) return {};
  return value.get<std::uint32_t>();
}

/// Null if there is no such member. It returns a reference: copying a deeply nested value from a
/// client would exhaust the stack.
const json& member(const json& object, const char* key) {
  static const json none;
  const auto found = object.find(key);
  return found == object.end() ? none : *found;
}

Request subscribe(const json& list) {
  Subscribe request;
  for (const auto& entry : list) {
    if (!entry.is_object()) return Refused{"subscriptions: objects with id and channelId"};
    const auto id = number_of(member(entry, "id"));
    const auto channel = number_of(member(entry, "channelId"));
    if (!id || !channel) return Refused{"subscriptions: id and channelId must be numbers"};
    request.subscriptions.push_back({*id, *channel});
  }
  return request;
}

Request unsubscribe(const json& list) {
  Unsubscribe request;
  for (const auto& entry : list) {
    const auto id = number_of(entry);
    if (!id) return Refused{"subscriptionIds: numbers"};
    request.ids.push_back(*id);
  }
  return request;
}

}  // namespace

std::string server_info(std::string_view name, std::string_view session, bool obeys) {
  const auto only = [obeys](const char* what) {
    return obeys ? json::array({what}) : json::array();
  };
  return json{{"op", "serverInfo"},
              {"name", name},
              {"capabilities", only("services")},
              {"supportedEncodings", only("json")},
              {"metadata", json::object()},
              {"sessionId", session}}
      .dump();
}

std::string advertise(std::span<const Channel> channels) {
  json list = json::array();
  for (const auto& channel : channels) {
    list.push_back({{"id", channel.id},
                    {"topic", channel.topic},
                    {"encoding", channel.encoding},
                    {"schemaName", channel.schema_name},
                    {"schema", channel.schema},
                    {"schemaEncoding", channel.schema_encoding}});
  }
  return json{{"op", "advertise"}, {"channels", list}}.dump();
}

std::string status(int level, std::string_view text) {
  return json{{"op", "status"}, {"level", level}, {"message", text}}.dump(
      -1, ' ', false, json::error_handler_t::replace);
}

DataHead data_head(std::uint32_t subscription, std::uint64_t time_ns) {
  DataHead head{1};
  boost::endian::store_little_u32(&head[1], subscription);
  boost::endian::store_little_u64(&head[5], time_ns);
  return head;
}

Request parse_request(std::string_view text) {
  const json request = json::parse(text, nullptr, false);
  if (!request.is_object()) return Refused{"a request is a JSON object"};
  const json& op = member(request, "op");
  if (!op.is_string()) return Refused{"a request has an \"op\""};
  const json &wanted = member(request, "subscriptions"),
             &unwanted = member(request, "subscriptionIds");
  if (op == "subscribe") {
    if (!wanted.is_array()) return Refused{"a subscribe has a list \"subscriptions\""};
    return subscribe(wanted);
  }
  if (op == "unsubscribe") {
    if (!unwanted.is_array()) return Refused{"an unsubscribe has a list \"subscriptionIds\""};
    return unsubscribe(unwanted);
  }
  constexpr std::size_t enough_to_know_it = 32;
  return Refused{"\"" + op.get_ref<const std::string&>().substr(0, enough_to_know_it) +
                 "\" is not served; known: subscribe, unsubscribe"};
}

}  // namespace drydock::live
