#pragma once

#include <vector>

#include "hil/pilot/loop_account.hpp"
#include "rig_config/mission.hpp"

namespace drydock::pilot {

/// The share of a change within which a quantity has settled.
inline constexpr double settled_within = 0.05;

/// The answers to the turns, dives and changes of speed among the legs, sailed once. Only those
/// whose leg has ended within the trace.
std::vector<StepResponse> step_responses(const rig_config::MissionConfig& mission,
                                         const LoopTrace& trace);

}  // namespace drydock::pilot
