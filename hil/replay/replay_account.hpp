#pragma once

#include <cstdio>

#include "hil/replay/replay_bench.hpp"

namespace drydock::replay {

/// What each device, fault and estimator of a replay did, as lines for its end.
void print_account(std::FILE* to, const rig_config::Rig& rig, const ReplayBench& bench);

/// How long it was, and why it may have been short.
void print_length(std::FILE* to, const record::Selection& part, const ReplayBench& bench);

}  // namespace drydock::replay
