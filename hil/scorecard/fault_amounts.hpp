#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rig_config/rig.hpp"

/// Which faults a scorecard tries, and with which amounts.
namespace drydock::scorecard {

/// When the fault begins and ends, in seconds of the run.
struct Window {
  double warm_up_s = 75, fault_s = 30, after_s = 45;

  double fault_end_s() const { return warm_up_s + fault_s; }
  double run_s() const { return fault_end_s() + after_s; }
};

/// One device with one fault.
struct Pair {
  std::size_t device = 0;  ///< index in the rig
  std::string label;       ///< "bias rate_degps": the fault word, and the quantity if the device
                           ///< has two
  rig_config::FaultConfig fault;
  std::optional<rig_config::FaultConfig> also{};  ///< of another device, at the same time
};

/// The fault with `times` its amount, within the limits of its word; the same fault if it has none.
rig_config::FaultConfig scaled(const rig_config::FaultConfig& fault, double times);

/// A fault for the whole window of text like "emlog:bias" with the amount of the scorecard. Throws
/// std::runtime_error with one line if the rig has no such pair.
rig_config::FaultConfig fault_named(const rig_config::Rig& rig, const Window& window,
                                    const std::string& text);

/// Every pair that rig_config::refusal() allows, by device in the order of the rig, then by word in
/// the order of the vocabulary. An empty selection means all. Throws std::runtime_error with one
/// line for an unknown name.
std::vector<Pair> pairs_of(const rig_config::Rig& rig, const Window& window,
                           const std::vector<std::string>& devices,
                           const std::vector<std::string>& faults);

}  // namespace drydock::scorecard
