#pragma once

#include <string>
#include <string_view>

#include "drivers/bus/entity.hpp"
#include "drivers/bus/message_types.hpp"

/// Topics, and the USER_DATA of their readers and writers.
namespace drydock::bus {

template <class Message>
Entity make_topic(std::int32_t participant, const std::string& name) {
  return Entity(dds_create_topic(participant, message_type<Message>.descriptor, name.c_str(),
                                 nullptr, nullptr),
                "topic " + name);
}

/// First `typehash=RIHS01_...;`, which ROS 2 needs, then `provenance=...;`, which ROS 2 ignores.
template <class Message>
std::string user_data(std::string_view provenance = {}) {
  std::string text;
  const auto append = [&text](std::string_view key, std::string_view value) {
    if (!value.empty()) text.append(key).append("=").append(value).append(";");
  };
  append("typehash", message_type<Message>.hash);
  append("provenance", provenance);
  return text;
}

}  // namespace drydock::bus
