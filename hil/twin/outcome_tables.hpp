#pragma once

#include "hil/report/table.hpp"
#include "hil/twin/outcome.hpp"

namespace drydock::twin {

/// When samples came, what errors they have against the track, and the filter's innovations: the
/// recording beside its twin.
std::vector<report::Table> tables_of(const TwinOutcome& outcome);

/// Sentences for a person: what was taken from where.
std::vector<std::string> notes_of(const TwinOutcome& outcome);

}  // namespace drydock::twin
