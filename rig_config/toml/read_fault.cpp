#include <fmt/format.h>

#include "rig_config/fault_quantity.hpp"
#include "rig_config/fault_vocabulary.hpp"
#include "rig_config/toml/read_keys.hpp"
#include "rig_config/typed/build.hpp"

namespace drydock::rig_config {

namespace {

std::string number_text(const Node& value) {
  if (value.kind != Node::Kind::array) return fmt::format("{}", value.number);
  return fmt::format("[{}, {}, {}]", value.items[0].number, value.items[1].number,
                     value.items[2].number);
}

/// A single number is the value of the first axis only, not of all axes.
void read_quantity(const Node& table, FaultConfig& fault) {
  for (const FaultQuantity& quantity : fault_quantities) {
    const Node* value = table.find(quantity.key);
    if (!value) continue;
    fault.quantity = quantity.key;
    if (value->kind != Node::Kind::array) fault.amount = {value->number * quantity.unit, 0, 0};
    for (std::size_t i = 0; i < value->items.size(); ++i)
      fault.amount.at(i) = value->items[i].number * quantity.unit;
    fault.words += fmt::format(", {} = {}", quantity.key, number_text(*value));
    return;
  }
}

FaultConfig build_fault(const Node& table, const std::string& file) {
  FaultConfig fault;
  const FaultWord& word = *find_fault(table.find("fault")->text);
  fault.kind = word.kind;
  fault.file = file;
  fault.line = table.at.line;
  read(table, "device", fault.device);
  fault.words = fmt::format("{}: {}", fault.device, word.name);
  read(table, "start_s", fault.start_s);
  fault.for_s = read_if(table, "for_s");
  fault.every_s = read_if(table, "every_s");
  read(table, "within_s", fault.within_s);
  read(table, "probability", fault.probability);
  if (const Node* seed = table.find("seed")) fault.seed = static_cast<std::uint64_t>(seed->integer);
  if (word.amount == "quantity") {
    read_quantity(table, fault);
  } else if (!word.amount.empty()) {
    fault.amount[0] = read_if(table, std::string(word.amount).c_str()).value_or(word.usual);
    fault.words += fmt::format(", {} = {}", word.amount, fault.amount[0]);
    if (word.amount == "probability") fault.probability = fault.amount[0];
  }
  return fault;
}

}  // namespace

std::vector<FaultConfig> build_faults(const Node& root, const std::string& file) {
  std::vector<FaultConfig> faults;
  for_each_table(root, "fault", [&](const Node& table, std::size_t) {
    faults.push_back(build_fault(table, file));
  });
  return faults;
}

}  // namespace drydock::rig_config
