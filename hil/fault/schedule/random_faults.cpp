#include "hil/fault/schedule/random_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rig_config/fault_quantity.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace drydock::fault {

namespace {

using rig_config::DeviceConfig;
using rig_config::FaultConfig;
using rig_config::FaultWord;

constexpr double shortest_s = 1, longest_s = 60;

/// A typical size of the quantity, in the unit of its key.
double typical(std::string_view quantity) {
  if (quantity == "position_m") return 50;
  if (quantity == "pressure_pa") return 2e4;
  if (quantity == "rate_degps" || quantity == "angle_deg" || quantity == "attitude_deg") return 10;
  if (quantity == "shaft_rpm") return 300;
  return 2;  // m/s, m/s2
}

/// One fault per word that the device can have, or one per quantity if the word has quantities.
std::vector<FaultConfig> possible_for(const DeviceConfig& device) {
  std::vector<FaultConfig> all;
  const auto add = [&](const FaultWord& word, std::string quantity, double size) {
    FaultConfig fault;
    fault.device = device.name;
    fault.kind = word.kind;
    fault.quantity = std::move(quantity);
    fault.amount[0] = size;
    fault.words = fmt::format("{}: {}", device.name, word.name);
    if (!rig_config::refusal(fault, device)) all.push_back(std::move(fault));
  };
  for (const FaultWord& word : rig_config::fault_vocabulary()) {
    if (word.amount == "quantity") {
      for (const auto& quantity : rig_config::fault_quantities)
        if (quantity.kind == device.kind)
          add(word, std::string(quantity.key), typical(quantity.key) * quantity.unit);
    } else {
      const bool given = std::isnan(word.usual);  // the word has no usual value: baud, seconds of a
                                                  // clock
      add(word, "", given ? (word.amount == "baud" ? 19200 : 3600) : word.usual);
    }
  }
  return all;
}

}  // namespace

RandomFaults::RandomFaults(const rig_config::Rig& rig, std::uint64_t seed, double mean_interval_s)
    : mean_interval_s_(mean_interval_s) {
  for (const DeviceConfig& device : rig.devices) {
    victims_.push_back({&device, possible_for(device), {seed, device.name, "random faults"}});
    victims_.back().next_s = interval(victims_.back().random);
  }
}

double RandomFaults::interval(sensor::RandomStream& random) const {
  return -mean_interval_s_ * std::log(1 - random.uniform());
}

FaultConfig RandomFaults::next() {
  Victim& victim = *std::ranges::min_element(victims_, {}, &Victim::next_s);
  auto& random = victim.random;
  FaultConfig fault = victim.possible[random.next() % victim.possible.size()];
  const FaultWord& word = rig_config::word_of(fault.kind);
  fault.start_s = victim.next_s;
  fault.for_s = shortest_s + (longest_s - shortest_s) * random.uniform();
  if (!std::isnan(word.usual) && word.highest > word.lowest) {
    fault.amount[0] = std::clamp(word.usual * 2 * random.uniform(), word.lowest, word.highest);
    if (word.amount == "probability") fault.probability = fault.amount[0];
  }
  victim.next_s += *fault.for_s + interval(random);
  return fault;
}

}  // namespace drydock::fault
