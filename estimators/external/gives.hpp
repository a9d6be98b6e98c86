#pragma once

#include "rig_config/estimator/external.hpp"

namespace drydock::external {

/// What each estimate of an estimator outside this program must have at least: roll and pitch, a
/// position, or a velocity over ground.
using Gives = rig_config::ExternalGives;

}  // namespace drydock::external
