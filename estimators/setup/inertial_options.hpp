#pragma once

#include "estimators/pipeline/inertial/inertial_options.hpp"
#include "rig_config/rig.hpp"

namespace drydock::setup {

/// Of an estimator of kind "navigation" or "velocity": its start, its sensors' places and grades,
/// its vehicle. The loader has checked that the devices named there exist.
pipeline::InertialOptions inertial_options(const rig_config::Rig& rig,
                                           const rig_config::EstimatorConfig& config);

}  // namespace drydock::setup
