#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rig_config/rig.hpp"

/// Which faults a scorecard tries, and how strong they are.
namespace drydock::scorecard {

/// When the fault comes and goes, seconds of the run.
struct Window {
  double warm_up_s = 75, fault_s = 30, after_s = 45;

  double fault_end_s() const { return warm_up_s + fault_s; }
  double run_s() const { return fault_end_s() + after_s; }
};

/// One device with one fault.
struct Pair {
  std::size_t device = 0;  ///< in the rig
  std::string label;       ///< "bias rate_degps": the word, and the quantity where there are two
  rig_config::FaultConfig fault;
};

/// Every pair that rig_config::refusal() allows, device by device in the order of the rig and of
/// the vocabulary. Empty selections: all. Throws std::runtime_error, one line, for a name that the
/// rig or the vocabulary does not have.
std::vector<Pair> pairs_of(const rig_config::Rig& rig, const Window& window,
                           const std::vector<std::string>& devices,
                           const std::vector<std::string>& faults);

}  // namespace drydock::scorecard
