#pragma once

#include "hil/study/mixing/mixing_statistics.hpp"
#include "hil/study/study.hpp"

namespace drydock::study {

/// Kim, Lee, Han, "Mixing Algorithm for Attitude Computation of Underwater Vehicle Using Fuzzy
/// Theory" (1996), chapter 4, with a fourth type in addition to the paper's three.
Result mixing_study(const Options& options, Progress& progress);

/// Table 6: a step of each type on readings of the experiment's first run.
std::vector<Workload> mixing_workloads();

/// Number of cells of the paper's Table 3, of 36, that the inference reproduces.
int mixing_table3_cells();

std::vector<report::Figure> mixing_figures(const MixingExperiment& experiment,
                                           const MixingResults& results);

}  // namespace drydock::study
