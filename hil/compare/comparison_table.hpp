#pragma once

#include "hil/compare/comparison.hpp"
#include "hil/report/table.hpp"

namespace drydock::compare {

/// A row for each estimator. Without a truth there are no columns of errors.
report::Table table_of(const Comparison& comparison);

/// Sentences for a person, those of the estimators with their choice before them.
std::vector<std::string> notes_of(const Comparison& comparison);

}  // namespace drydock::compare
