#pragma once

#include "drivers/decode/replay.hpp"
#include "hil/summary/summary.hpp"

namespace drydock::replay {

/// A capture of one sensor through its driver, as the summary of a run: its health at the end of
/// the capture and its measurements as curves. Throws std::exception with one line if there is no
/// such driver or the capture cannot be read.
summary::Summary summary_of_capture(decode::ReplayOptions capture);

}  // namespace drydock::replay
