#pragma once

#include <string>
#include <vector>

#include "estimators/pipeline/pipeline.hpp"
#include "estimators/setup/outside.hpp"
#include "hil/summary/verdict.hpp"
#include "rig_config/rig.hpp"

namespace drydock::replay {

/// How a replay reaches the estimators of a rig that the user names. It starts their programs, and
/// virtual time waits for the answers. Those on a topic of the bus are not asked: a replay
/// publishes no measurements.
setup::Outside programs_of(const rig_config::Rig& rig, setup::Outside::Say say);

/// One on each program that was asked.
std::vector<summary::Verdict> verdicts_on_programs(const rig_config::Rig& rig,
                                                   const pipeline::Pipeline& pipeline);

}  // namespace drydock::replay
