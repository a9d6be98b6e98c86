#include "drivers/decode/signal_keys.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

namespace drydock::decode {
namespace {

constexpr std::array<std::string_view, 5> own_keys{"type", "time_s", "interface", "source",
                                                   "destination"};

std::string unused(const std::string& name, std::set<std::string>& used) {
  std::string key = std::ranges::find(own_keys, name) == own_keys.end() ? name : "device_" + name;
  const std::string first = key;
  for (int i = 2; !used.insert(key).second; ++i) key = first + "_" + std::to_string(i);
  return key;
}

}  // namespace

std::vector<SignalKeys> keys_of(const wire::dbc::Message& message) {
  std::set<std::string> used;
  std::vector<SignalKeys> keys;
  for (const auto& signal : message.signals) keys.push_back({unused(signal.long_name, used), {}});
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (!message.signals[i].labels.empty()) keys[i].label = unused(keys[i].number + "_label", used);
  return keys;
}

}  // namespace drydock::decode
