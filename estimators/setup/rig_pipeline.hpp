#pragma once

#include <string>
#include <vector>

#include "estimators/pipeline/options.hpp"
#include "estimators/pipeline/pipeline.hpp"
#include "rig_config/rig.hpp"

namespace drydock::setup {

/// What the rig file says of its estimators, as the pipeline's options. The loader has checked that
/// the devices named there exist.
pipeline::PipelineOptions pipeline_options(const rig_config::Rig& rig);

/// A line for each device whose measurements came too late for the estimators or were refused, and
/// one if the reorder buffer was too small; none when all is well.
std::vector<std::string> pipeline_notes(const rig_config::Rig& rig,
                                        const pipeline::Pipeline& pipeline);

}  // namespace drydock::setup
