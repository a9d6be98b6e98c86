#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rig_config/checks/checks.hpp"
#include "rig_config/fault_quantity.hpp"
#include "rig_config/fault_vocabulary.hpp"
#include "rig_config/rules/explain.hpp"

namespace drydock::rig_config {

namespace {

/// Keys that every fault may have. Other keys depend on the kind of fault.
constexpr std::array common_keys{"device", "fault", "start_s", "for_s", "every_s", "seed"};

bool is_quantity(std::string_view key) {
  return std::ranges::find(fault_quantities, key, &FaultQuantity::key) != fault_quantities.end();
}

class FaultChecks {
 public:
  FaultChecks(const Node& root, const std::string& file) : root_(root), file_(file) {}

  Problems run() {
    for_each_table(root_, "fault", [&](const Node& fault, std::size_t i) {
      path_ = fmt::format("/fault/{}", i);
      const Node* name = fault.find_text("fault");
      const FaultWord* word = name ? find_fault(name->text) : nullptr;
      if (!word) return;
      keys_fit(fault, *word);
      amount_is_given(fault, *word);
      ends_before_it_begins_again(fault);
    });
    return std::move(problems_);
  }

 private:
  static bool fits(const std::string& key, const FaultWord& word) {
    if (std::ranges::find(common_keys, key) != common_keys.end()) return true;
    if (key == word.amount) return true;
    if (word.facts.extra && key == word.facts.extra->key) return true;
    return word.amount == "quantity" && is_quantity(key);
  }

  static std::vector<std::string> keys_of(const FaultWord& word) {
    std::vector<std::string> keys;
    if (word.amount == "quantity") {
      for (const auto& quantity : fault_quantities)
        if (std::ranges::find(keys, quantity.key) == keys.end()) keys.emplace_back(quantity.key);
    } else if (!word.amount.empty()) {
      keys.emplace_back(word.amount);
    }
    if (word.facts.extra) keys.emplace_back(word.facts.extra->key);
    return keys;
  }

  void keys_fit(const Node& fault, const FaultWord& word) {
    for (const auto& [key, value] : fault.members) {
      if (fits(key, word)) continue;
      const auto allowed = keys_of(word);
      add(value.key_at, key,
          fmt::format("the fault \"{}\" has no {}, allowed: {}", word.name, key,
                      allowed.empty() ? "start_s, for_s, every_s" : listed(allowed)));
    }
  }

  void amount_is_given(const Node& fault, const FaultWord& word) {
    if (word.amount.empty()) return;
    if (word.amount == "quantity") {
      const auto given = std::ranges::count_if(
          fault.members, [](const Node::Member& member) { return is_quantity(member.key); });
      if (given != 1)
        add(fault.at, "",
            fmt::format("the fault \"{}\" needs one of: {}", word.name, listed(keys_of(word))));
      return;
    }
    const Node* amount = fault.find(word.amount);
    if (!amount) {
      if (std::isnan(word.usual))
        add(fault.at, "", fmt::format("the fault \"{}\" needs {}", word.name, word.amount));
    } else if (amount->number < word.lowest || amount->number > word.highest) {
      add(amount->at, std::string(word.amount),
          fmt::format("{} is out of range, allowed: {} to {}", amount->number, word.lowest,
                      word.highest));
    }
  }

  void ends_before_it_begins_again(const Node& fault) {
    const Node* again = fault.find("every_s");
    const Node* lasts = fault.find("for_s");
    if (!again) return;
    if (!lasts)
      add(again->at, "every_s", "a fault that comes again needs for_s");
    else if (lasts->number >= again->number)
      add(again->at, "every_s", fmt::format("must be above for_s, which is {}", lasts->number));
  }

  void add(Position at, const std::string& key, std::string what) {
    problems_.push_back(
        {file_, at.line, at.column, key.empty() ? path_ : path_ + "/" + key, std::move(what)});
  }

  const Node& root_;
  const std::string& file_;
  std::string path_;
  Problems problems_;
};

}  // namespace

Problems check_faults(const Node& root, const std::string& file) {
  return FaultChecks(root, file).run();
}

Problems check_faults_of(const Rig& rig, FaultTarget target) {
  Problems problems;
  std::vector<std::string> names;
  for (const auto& device : rig.devices) names.push_back(device.name);
  for (const FaultConfig& fault : rig.faults) {
    const auto device = std::ranges::find(rig.devices, fault.device, &DeviceConfig::name);
    std::optional<std::string> why;
    if (device == rig.devices.end())
      why = fmt::format("no device is named \"{}\"{}, allowed: {}", fault.device,
                        did_you_mean(fault.device, names), listed(names));
    else
      why = refusal(fault, *device, target);
    if (why) problems.push_back({fault.file, fault.line, 1, "/fault", *why});
  }
  return problems;
}

}  // namespace drydock::rig_config
