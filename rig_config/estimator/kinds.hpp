#pragma once

#include <array>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "rig_config/estimator/external.hpp"
#include "rig_config/estimator/leveling.hpp"
#include "rig_config/estimator/mixing.hpp"
#include "rig_config/estimator/navigation.hpp"
#include "rig_config/estimator/reckoning.hpp"
#include "rig_config/estimator/roll.hpp"
#include "rig_config/estimator/velocity.hpp"

namespace drydock::rig_config {

/// All kinds of estimators. This list is the only one: names, checks and reading follow from it.
using EstimatorKind = std::variant<LevelingConfig, MixingConfig, RollConfig, NavigationConfig,
                                   VelocityConfig, ReckoningConfig, ExternalConfig>;

/// The rows of all kinds, in the order of EstimatorKind.
inline constexpr auto estimator_facts =
    []<class... Kind>(std::type_identity<std::variant<Kind...>>) {
      return std::array{Kind::facts...};
    }(std::type_identity<EstimatorKind>{});

/// The row of its kind, or its own one if its keys decide.
const EstimatorFacts& facts_of(const EstimatorKind& kind);

/// The row of the kind with this name, or nullptr.
const EstimatorFacts* facts_named(std::string_view name);

/// The kind of a checked block, with its keys. Its other files are not yet read.
EstimatorKind read_estimator_kind(const Node& table);

/// Names of the devices whose values the estimator compares with what it expects. Empty names:
/// the estimator does not have this device.
std::vector<std::string> devices_compared_by(const EstimatorKind& kind);

}  // namespace drydock::rig_config
