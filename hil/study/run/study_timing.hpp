#pragma once

#include <vector>

#include "hil/study/study.hpp"

namespace drydock::study {

/// Measures a study's workloads on this machine, in turns, and adds a table of their times and the
/// first one's multiples to the result, and `ns_per_step` to its JSON.
void add_step_times(std::vector<study::Workload> workloads, study::Result& result);

}  // namespace drydock::study
