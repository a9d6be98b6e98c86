#pragma once

#include "estimators/pipeline/inertial/inertial_options.hpp"
#include "rig_config/rig.hpp"

namespace drydock::setup {

/// The options of an estimator of kind "navigation" or "velocity": its start, the positions and
/// grades of its sensors, and its vehicle. The loader has checked that the named devices exist.
pipeline::InertialOptions inertial_options(const rig_config::Rig& rig,
                                           const rig_config::EstimatorConfig& config);

}  // namespace drydock::setup
