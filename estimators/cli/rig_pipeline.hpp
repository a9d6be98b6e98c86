#pragma once

#include "estimators/pipeline/options.hpp"
#include "rig_config/rig.hpp"

namespace drydock::cli {

/// What the rig file says of its estimators, as the pipeline's options. The loader has checked that
/// the devices named there exist.
pipeline::PipelineOptions pipeline_options(const rig_config::Rig& rig);

}  // namespace drydock::cli
