#pragma once

#include "hil/study/study.hpp"

namespace drydock::study {

/// The GPS roll paper's experiment: its method, the same with a gyro bias, and all satellites; on
/// ideal signals, as wires carry them, and with everything that goes wrong together.
Result run_roll_study(const Options& options, Progress& progress);

}  // namespace drydock::study
