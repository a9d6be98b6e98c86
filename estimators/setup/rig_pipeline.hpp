#pragma once

#include <string>
#include <vector>

#include "estimators/pipeline/options.hpp"
#include "estimators/pipeline/pipeline.hpp"
#include "estimators/setup/outside.hpp"
#include "rig_config/rig.hpp"

namespace drydock::setup {

/// Converts the estimators of the rig file to the options of the pipeline. The loader has checked
/// that the named devices exist. `outside`: how estimators in other programs are reached; null:
/// they are not.
pipeline::PipelineOptions pipeline_options(const rig_config::Rig& rig,
                                           const Outside* outside = nullptr);

/// One line for each device with late or refused measurements, for each estimator that rejected
/// values or was lost, and for a reorder buffer that was too small. Empty if there was no problem.
std::vector<std::string> pipeline_notes(const rig_config::Rig& rig,
                                        const pipeline::Pipeline& pipeline);

}  // namespace drydock::setup
