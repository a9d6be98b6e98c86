#pragma once

#include <span>
#include <string>
#include <vector>

#include "rig_config/rig.hpp"

/// Which faults each device can have, for who chooses one.
namespace drydock::control {

std::vector<const rig_config::FaultWord*> fault_words_of(const rig_config::DeviceConfig& device);

/// The keys of the word's amount, one of which is given: "velocity_mps|position_m"; empty: none.
std::string amount_keys(const rig_config::FaultWord& word, const rig_config::DeviceConfig& device);

/// By device: [{"fault","layer","amount","meaning","amounts":[key],"more":[key]}], a key being
/// {"key","usual","lowest","highest"}; usual null: to be given; of a quantity the key alone.
std::string fault_words_json(std::span<const rig_config::DeviceConfig> devices);

}  // namespace drydock::control
