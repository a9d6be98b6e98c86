#pragma once

#include <optional>

#include "hil/summary/summary.hpp"

namespace drydock::bench {

/// The failed verdict of a run that ended before its time, however it ended. Empty: it reached it.
/// `asked_s` is what --for says, 0: nothing.
std::optional<summary::Verdict> verdict_of_short_run(const summary::Summary& summary,
                                                     double asked_s);

}  // namespace drydock::bench
