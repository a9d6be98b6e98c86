#pragma once

#include "hil/study/leveling/leveling_statistics.hpp"
#include "hil/study/study.hpp"

namespace drydock::study {

/// Hong, Park, Han, Lee, "A Leveling Algorithm for Strapdown INS Using EKF" (2000), chapter 4, with
/// three filters.
Result leveling_study(const Options& options, Progress& progress);

std::vector<report::Table> leveling_tables(const LevelingResults& results);
std::vector<report::Figure> leveling_figures(const LevelingResults& results);

}  // namespace drydock::study
