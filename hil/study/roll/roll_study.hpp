#pragma once

#include "hil/study/study.hpp"

namespace drydock::study {

/// The GPS roll paper's experiment: its method, the same with a gyro bias, and all satellites. The
/// cases are ideal signals, signals as on the wire, and all errors together.
Result run_roll_study(const Options& options, Progress& progress);

}  // namespace drydock::study
