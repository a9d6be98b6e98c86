#include "hil/control/fault_words.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "rig_config/fault_quantity.hpp"

namespace drydock::control {

namespace {

using OrderedJson = nlohmann::ordered_json;
using rig_config::DeviceConfig;
using rig_config::FaultWord;

/// The keys are members of FaultWord and FaultExtra.
template <class Range>
OrderedJson key_json(std::string_view key, const Range& range) {
  return {{"key", key},
          {"usual", std::isnan(range.usual) ? OrderedJson() : OrderedJson(range.usual)},
          {"lowest", range.lowest},
          {"highest", range.highest}};
}

OrderedJson amounts_json(const FaultWord& word, const DeviceConfig& device) {
  OrderedJson amounts = OrderedJson::array();
  if (word.amount == "quantity") {
    for (const auto& quantity : rig_config::fault_quantities)
      if (quantity.kind == device.kind)
        amounts.push_back({{"key", quantity.key}, {"usual", nullptr}});
  } else if (!word.amount.empty()) {
    amounts.push_back(key_json(word.amount, word));
  }
  return amounts;
}

OrderedJson word_json(const FaultWord& word, const DeviceConfig& device) {
  OrderedJson more = OrderedJson::array();
  if (const auto& extra = word.facts.extra) more.push_back(key_json(extra->key, *extra));
  return {{"fault", word.name},
          {"layer", rig_config::name_of(word.layer)},
          {"amount", amount_keys(word, device)},
          {"meaning", word.meaning},
          {"amounts", amounts_json(word, device)},
          {"more", more}};
}

}  // namespace

std::vector<const FaultWord*> fault_words_of(const DeviceConfig& device) {
  std::vector<const FaultWord*> words;
  for (const FaultWord& word : rig_config::fault_vocabulary()) {
    rig_config::FaultConfig fault;
    fault.kind = word.kind;
    if (!rig_config::refusal(fault, device)) words.push_back(&word);
  }
  return words;
}

std::string amount_keys(const FaultWord& word, const DeviceConfig& device) {
  if (word.amount != "quantity") return std::string(word.amount);
  std::string keys;
  for (const auto& quantity : rig_config::fault_quantities)
    if (quantity.kind == device.kind) keys += (keys.empty() ? "" : "|") + std::string(quantity.key);
  return keys;
}

std::string fault_words_json(std::span<const DeviceConfig> devices) {
  OrderedJson all = OrderedJson::object();
  for (const DeviceConfig& device : devices) {
    OrderedJson& words = all[device.name] = OrderedJson::array();
    for (const FaultWord* word : fault_words_of(device)) words.push_back(word_json(*word, device));
  }
  return all.dump();
}

}  // namespace drydock::control
