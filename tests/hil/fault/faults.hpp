#pragma once

#include "hil/fault/schedule/schedule.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace drydock::fault::test {

using namespace std::chrono_literals;

inline const Stamp start = measurement::stamp_from_ns(1'700'000'000'000'000'000);

/// A fault as the loader creates it.
inline FaultConfig fault_of(FaultKind kind, double amount = 0, double probability = 1) {
  FaultConfig fault;
  fault.device = "dvl";
  fault.kind = kind;
  fault.amount = {amount, 0, 0};
  fault.probability = probability;
  fault.words = std::string(rig_config::word_of(kind).name);
  return fault;
}

/// In force since `start`, while `faults` lives.
inline std::vector<InForce> in_force(const std::vector<FaultConfig>& faults) {
  std::vector<InForce> all;
  for (const FaultConfig& fault : faults) all.push_back({&fault, start, {}});
  return all;
}

}  // namespace drydock::fault::test
