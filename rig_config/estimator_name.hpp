#pragma once

#include <algorithm>
#include <string_view>

namespace drydock::rig_config {

/// The name of the true motion in topics, recordings and on the page: no estimator may have it.
inline constexpr std::string_view name_of_truth = "truth";

/// As "topic_name" of rig.schema.json: letters, digits and _, a letter first.
inline bool is_topic_name(std::string_view name) {
  const auto letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
  return !name.empty() && letter(name.front()) && std::ranges::all_of(name, [&](char c) {
    return letter(c) || (c >= '0' && c <= '9') || c == '_';
  });
}

inline bool may_be_estimator(std::string_view name) {
  return is_topic_name(name) && name != name_of_truth;
}

}  // namespace drydock::rig_config
