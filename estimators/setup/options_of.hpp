#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "estimators/pipeline/options.hpp"
#include "estimators/setup/outside.hpp"
#include "rig_config/rig.hpp"

namespace drydock::setup {

/// An estimator and its rig, which has the devices that it names.
struct EstimatorInRig {
  const rig_config::Rig& rig;
  const rig_config::EstimatorConfig& estimator;
  const Outside* outside = nullptr;  ///< null: programs outside are not reached
};

/// The options of each kind of estimator. `pipeline_options` visits them: a kind without its line
/// here does not compile. The loader has checked that the named devices exist.
pipeline::LevelingOptions options_of(const rig_config::LevelingConfig&, const EstimatorInRig&);
pipeline::MixingOptions options_of(const rig_config::MixingConfig&, const EstimatorInRig&);
pipeline::RollOptions options_of(const rig_config::RollConfig&, const EstimatorInRig&);
pipeline::InertialOptions options_of(const rig_config::NavigationConfig&, const EstimatorInRig&);
pipeline::InertialOptions options_of(const rig_config::VelocityConfig&, const EstimatorInRig&);
pipeline::ReckoningOptions options_of(const rig_config::ReckoningConfig&, const EstimatorInRig&);
pipeline::ExternalOptions options_of(const rig_config::ExternalConfig&, const EstimatorInRig&);

const rig_config::DeviceConfig* find_device(const rig_config::Rig& rig, const std::string& name);

/// The first DVL of the rig, which watches the IMU of the estimator; its lever is from that IMU.
/// Empty: the rig has none.
std::optional<pipeline::AidingSensor> witness_of(const EstimatorInRig& place);

/// Device index; empty if the name is empty.
std::optional<std::uint16_t> index_of(const rig_config::Rig& rig, const std::string& name);

}  // namespace drydock::setup
