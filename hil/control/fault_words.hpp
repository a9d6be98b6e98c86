#pragma once

#include <span>
#include <string>
#include <vector>

#include "rig_config/fault_vocabulary.hpp"
#include "rig_config/rig.hpp"

/// The faults that each device can have, for a user who chooses one.
namespace drydock::control {

std::vector<const rig_config::FaultWord*> fault_words_of(const rig_config::DeviceConfig& device);

/// The keys of the word's amount: "velocity_mps|position_m". A fault gives one of them. Empty if
/// the word has no amount.
std::string amount_keys(const rig_config::FaultWord& word, const rig_config::DeviceConfig& device);

/// By device: [{"fault","layer","amount","meaning","amounts":[key],"more":[key]}]. A key is
/// {"key","usual","lowest","highest"}; `usual` is null where a fault must give the value. A
/// quantity has only "key".
std::string fault_words_json(std::span<const rig_config::DeviceConfig> devices);

}  // namespace drydock::control
