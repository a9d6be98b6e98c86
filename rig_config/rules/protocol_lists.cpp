#include "rig_config/rules/protocol_lists.hpp"

#include <nlohmann/json.hpp>
#include <string>

namespace drydock::rig_config {

namespace {

bool belongs(const wire::Protocol& protocol, std::string_view list) {
  if (protocol.kinds.empty()) return false;
  if (list == "all") return true;
  if (list == "bytes") return protocol.travels == wire::Travels::as_bytes;
  if (list == "frames") return protocol.travels == wire::Travels::as_frames;
  if (list == "canopen") return protocol.network == wire::Network::canopen;
  return protocol.kinds.has(measurement::kind_of(list).value());
}

}  // namespace

nlohmann::json with_protocol_lists(nlohmann::json schema,
                                   std::span<const wire::Protocol> described) {
  if (schema.is_object() && schema.contains("protocols") && schema["protocols"].is_string()) {
    const auto list = schema["protocols"].get<std::string>();
    auto names = nlohmann::json::array();
    for (const wire::Protocol& protocol : wire::protocols())
      if (belongs(protocol, list)) names.push_back(std::string(protocol.name));
    for (const wire::Protocol& protocol : described)
      if (belongs(protocol, list)) names.push_back(std::string(protocol.name));
    return {{"enum", std::move(names)}};
  }
  for (auto& part : schema)
    if (part.is_structured()) part = with_protocol_lists(std::move(part), described);
  return schema;
}

}  // namespace drydock::rig_config
