#pragma once

#include <optional>
#include <string>

#include "hil/summary/summary.hpp"

namespace drydock::bench {

/// The failed verdict of a run that ended before its time, however it ended. Empty: it reached it.
/// `asked_s` is what --for says, 0: nothing.
std::optional<summary::Verdict> verdict_of_short_run(const summary::Summary& summary,
                                                     double asked_s);

/// "a run of 2651.0 s, not of 3600000 s: a signal ended it".
std::string short_run_in_words(const summary::Summary& summary, double asked_s);

}  // namespace drydock::bench
