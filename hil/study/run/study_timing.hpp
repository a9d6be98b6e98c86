#pragma once

#include <vector>

#include "hil/study/study.hpp"

namespace drydock::study {

/// Measures a study's workloads on this machine, one after another in turns. Adds a table of their
/// times, with ratios to the first, to the result, and `ns_per_step` to its JSON.
void add_step_times(std::vector<study::Workload> workloads, study::Result& result);

}  // namespace drydock::study
